"""What fitting needs from training: how estimates err on unseen takes, and other poses to try."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import ceil
from typing import Any, Self

import numpy as np

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.core.stages import stage, timed
from silpose.core.types import Array
from silpose.dataset import Take
from silpose.fitting import (
    BodyFitter,
    ChosenOptions,
    Confidence,
    FittingOptions,
    LegMotion,
    PosePrior,
)
from silpose.model.left_out import regressed_left_out, tracked_left_out
from silpose.model.pose_fitter import PoseFitter
from silpose.model.training import DescribedDataset
from silpose.regression import DistinctNeighbours, Regressor
from silpose.silhouette import Body, Camera
from silpose.tracking import Tracker

_EXAMPLES = 3000  # training examples that a model keeps for further starts
_TAKES, _FRAMES_EACH = 8, 4  # to which the body is fitted to see how it usually overlaps


@dataclass(frozen=True, eq=False)
class FitterTraining:
    """A described dataset, and what a fitter learns from it when that is first needed.

    Attributes
    ----------
    described : DescribedDataset
    regressor : Regressor
        Fitted to all training takes; its estimates are what fits start from.
    options : ChosenOptions
    body : Body
        Of rigid links.
    camera : Camera
        Camera of takes that have none of their own.
    tracker : Tracker or None, default=None
        Fitted to all training takes; then whole takes start from its estimates.
    lag : int, default=0
        Frames that these may wait for.

    See Also
    --------
    FitterTraining.of : Creates one.
    """

    described: DescribedDataset
    regressor: Regressor
    options: ChosenOptions
    body: Body
    camera: Camera
    tracker: Tracker | None = None
    lag: int = 0

    @classmethod
    def of(
        cls,
        described: DescribedDataset,
        regressor: Regressor,
        options: FittingOptions,
        body: Body,
        camera: Camera,
        tracker: Tracker | None = None,
        lag: int = 0,
    ) -> Self:
        """Prepare the training of a fitter.

        Parameters
        ----------
        described : DescribedDataset
        regressor : Regressor
            Fitted, with the settings that have been chosen.
        options : FittingOptions
        body : Body
            That of the person; of a skinned body the rigid one of the same shape is fitted.
        camera : Camera
        tracker : Tracker, optional
        lag : int, default=0

        Raises
        ------
        InputError
            If the dataset holds no masks, or poses that are no angles.
        """
        data = described.data
        if not data.has_masks or data.space is not ANGLES:
            raise InputError(
                "a body is fitted to masks with poses as angles, which these data do not hold: "
                "choose a dataset that is rendered, such as dataset=same_performer"
            )
        if body.kind != "convex":
            body = Body(shape=body.shape)
        chosen = options.or_those_of(ChosenOptions())
        return cls(described, regressor, chosen, body, camera, tracker, lag)

    @cached_property
    def left_out(self) -> list[Array]:
        """Estimates (F, 55) of each training take by a regressor not trained on it.

        Nor on any take by the same performer, where performers are kept apart.
        """
        with stage("fitting"):
            return regressed_left_out(self.regressor, self.described.train, self.described.groups)

    @cached_property
    def prior(self) -> PosePrior:
        """How the regressor's estimates err on training takes that are left out."""
        takes = [str(take) for take in range(len(self.described.train))]
        return self._prior_of(self.left_out, self.described.groups or takes)

    @cached_property
    def tracked_prior(self) -> PosePrior | None:
        """How the tracker's estimates err on such takes; None without a tracker.

        They are not widened by the number of performers: intervals of whole takes hold without.
        """
        if self.tracker is None:
            return None
        train, groups = self.described.train, self.described.groups
        with stage("fitting"):
            return self._prior_of(tracked_left_out(self.tracker, self.lag, train, groups))

    @cached_property
    def leg_motion(self) -> LegMotion | None:
        """How legs move on in the training takes."""
        takes = self.described.data.train
        angles = [np.deg2rad(ANGLES.angles(take.x)) for take in takes]
        return LegMotion.learn(angles, takes[0].frames_per_second)

    def _prior_of(
        self, estimated: Sequence[Array], performers: Sequence[str] | None = None
    ) -> PosePrior:
        return PosePrior.from_errors(
            [x for _, x in self.described.train],
            estimated,
            self.described.data.train[0].frames_per_second,
            performers=performers,
            lasting=self.options.lasting,
            seconds=self.options.seconds,
        )

    def starts(self, z: Array) -> tuple[Array, Array]:
        """Estimate poses, and find others with similar silhouettes.

        Parameters
        ----------
        z : ndarray, shape (F, d)
            A row of NaN has none.

        Returns
        -------
        mean : ndarray, shape (F, 55)
            The regressor's estimates.
        others : ndarray, shape (F, S, 55)
            Training poses that differ from each other, as many as the options say.
        """
        seen = np.isfinite(z).all(axis=1)
        mean = np.full((len(z), len(ANGLES.columns)), np.nan)
        if seen.any():
            mean[seen] = self.regressor.predict(z[seen])
        return mean, self._neighbours.find(z, self.options.starts)

    @cached_property
    def _neighbours(self) -> DistinctNeighbours:
        return DistinctNeighbours(*self.described.joined("train"), ANGLES.distance)

    def fitter(
        self, *, camera: Camera | None = None, prior: PosePrior | None = None, **overrides: Any
    ) -> BodyFitter:
        """Create the fitter.

        Parameters
        ----------
        camera : Camera, optional
            That of the take, if it has one of its own.
        prior : PosePrior, optional
            Of the estimates that fits start from; by default of the regressor's.
        **overrides
            Arguments of `BodyFitter` to use instead of the options.
        """
        options = self.options
        arguments: dict[str, Any] = {
            "camera_is": options.camera,
            "shape_is": options.shape,
            "whole_take": options.whole_take,
            "iterations": options.iterations,
            "leg_motion": self.leg_motion,
        }
        if "confidence" not in overrides:
            arguments["confidence"] = Confidence(usual_iou=self.usual_iou)
        prior = self.prior if prior is None else prior
        return BodyFitter(self.body, camera or self.camera, prior, **(arguments | overrides))

    @cached_property
    def usual_iou(self) -> float:
        """Median overlap of body and mask in some training frames, each left out and fitted."""
        return self._usual_iou()

    @timed("fitting")
    def _usual_iou(self) -> float:
        takes = self.described.data.train
        overlaps = [
            self._overlaps(takes[k], self.left_out[k])
            for k in np.unique(np.linspace(0, len(takes) - 1, _TAKES).round().astype(int))
        ]
        return float(np.median(np.concatenate(overlaps)))

    def _overlaps(self, take: Take, estimated: Array) -> Array:
        """Overlaps of a few frames of a take."""
        assert take.masks is not None
        every = max(1, len(take) // _FRAMES_EACH)
        frames = range(every // 2, len(take), every)
        camera, sure = take.camera_or(self.camera), Confidence()
        fitter = self.fitter(camera=camera, whole_take=False, confidence=sure)
        return fitter.fit(
            [take.masks[frame] for frame in frames],
            estimated[frames],
            roots=take.offset[frames],
            frames_per_second=take.frames_per_second / every,
        ).iou

    @cached_property
    def pose_fitter(self) -> PoseFitter:
        """What a model keeps."""
        z, x = self.described.joined("train")
        every = ceil(len(z) / _EXAMPLES)
        return PoseFitter(
            self.fitter(), z[::every], x[::every], self.options.starts, self.tracked_prior
        )

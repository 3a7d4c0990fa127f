"""What fitting needs from training: how estimates err on unseen takes, and other poses to try."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, partial
from math import ceil
from typing import Any, Self

import numpy as np
from sklearn.base import clone

from silpose.core.errors import InputError
from silpose.core.parallel import parallel_map
from silpose.core.pose_space import ANGLES
from silpose.core.stages import timed
from silpose.core.types import Array
from silpose.dataset import Take
from silpose.fitting import BodyFitter, FittingOptions, PosePrior
from silpose.model.pose_fitter import PoseFitter
from silpose.model.training import DescribedDataset
from silpose.regression import DistinctNeighbours, Fold, Regressor, folds
from silpose.silhouette import Body, Camera

_OWN_POSTURE = 0.3  # share of the variance of estimates' errors that is a performer's posture
_FOLDS = 8  # largest number of parts in which training takes are left out
_FRAMES = 10_000  # frames, about, that a regressor is fitted to when some are left out
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
    options : FittingOptions
    body : Body
        Of rigid links.
    camera : Camera
        Camera of takes that have none of their own.

    See Also
    --------
    FitterTraining.of : Creates one.
    """

    described: DescribedDataset
    regressor: Regressor
    options: FittingOptions
    body: Body
    camera: Camera

    @classmethod
    def of(
        cls,
        described: DescribedDataset,
        regressor: Regressor,
        options: FittingOptions,
        body: Body,
        camera: Camera,
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
        return cls(described, regressor, options, body, camera)

    @cached_property
    def left_out(self) -> list[Array]:
        """Estimates (F, 55) of each training take by a regressor not trained on it.

        Nor on any take by the same performer, where performers are kept apart.
        """
        train = self.described.train
        return self._left_out(folds(train, most=_FOLDS, groups=self.described.groups))

    @timed("fitting")
    def _left_out(self, parts: list[Fold]) -> list[Array]:
        takes = {id(take): k for k, take in enumerate(self.described.train)}
        estimates = [np.empty(0)] * len(takes)
        fitted = parallel_map(
            partial(_refitted, self.regressor), parts, description="leaving takes out",
            prefer="threads",
        )  # fmt: skip
        for part, regressor in zip(parts, fitted, strict=True):
            for take in part.validation:
                estimates[takes[id(take)]] = regressor.predict(take[0])
        return estimates

    @cached_property
    def prior(self) -> PosePrior:
        """How estimates err on training takes that are left out."""
        return PosePrior.from_errors(
            [x for _, x in self.described.train],
            self.left_out,
            self.described.data.train[0].frames_per_second,
            lasting=self._lasting,
            seconds=self.options.seconds,
        )

    @property
    def _lasting(self) -> float:
        """Share of the errors that lasts: the own posture of performers who are not in training."""
        if self.options.lasting is not None:
            return self.options.lasting
        data = self.described.data
        known = {take.performer for take in data.train}
        return 0.0 if {take.performer for take in data.test} <= known else _OWN_POSTURE

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

    def fitter(self, *, camera: Camera | None = None, **overrides: Any) -> BodyFitter:
        """Create the fitter.

        Parameters
        ----------
        camera : Camera, optional
            That of the take, if it has one of its own.
        **overrides
            Arguments of `BodyFitter` to use instead of the options.
        """
        options = self.options
        arguments: dict[str, Any] = {
            "camera_is": options.camera,
            "shape_is": options.shape,
            "whole_take": options.whole_take,
            "iterations": options.iterations,
        }
        return BodyFitter(self.body, camera or self.camera, self.prior, **(arguments | overrides))

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
        fitter = self.fitter(camera=take.camera_or(self.camera), whole_take=False)
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
            self.fitter(), z[::every], x[::every], self.options.starts, self.usual_iou
        )


def _refitted(regressor: Regressor, fold: Fold) -> Regressor:
    """Fit a regressor of the same settings to a fold's training takes."""
    every = ceil(len(fold.z) / _FRAMES)
    fitted: Regressor = clone(regressor).fit(fold.z[::every], fold.x[::every])
    return fitted

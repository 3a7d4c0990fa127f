"""A fitter that is part of a model: the body, how the model's estimates err, and further starts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from functools import cached_property
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.core.serialisation import State, prefixed, unwrapped, without_prefix
from silpose.core.types import Array, Mask
from silpose.fitting import (
    BodyFitter,
    ChosenOptions,
    Confidence,
    Fit,
    FitterStream,
    FittingOptions,
    LegMotion,
    Matching,
    PosePrior,
)
from silpose.regression import DistinctNeighbours
from silpose.silhouette import Body, Camera

_CHOICES = ("camera_is", "shape_is", "whole_take", "iterations")


@dataclass(frozen=True, eq=False)
class PoseFitter:
    """Fits the body to masks whose poses a model has estimated.

    Attributes
    ----------
    fitter : BodyFitter
        Its camera is that of training; masks of another size are taken to be seen by a camera
        that differs in nothing else.
    z, x : ndarray, shapes (n, d) and (n, 55)
        Training examples, among which further starts are found.
    starts : int
        Number of further starts of each frame.
    tracked_prior : PosePrior or None, default=None
        How the estimates of the model's tracker err, if it has one.
    """

    fitter: BodyFitter
    z: Array
    x: Array
    starts: int
    tracked_prior: PosePrior | None = None

    def fit(
        self,
        masks: Sequence[Mask],
        z: Array,
        x: Array,
        *,
        tracked: Array | None = None,
        roots: ArrayLike | None = None,
        frames_per_second: float = 15.0,
    ) -> Fit:
        """Fit the body to masks.

        Parameters
        ----------
        masks : sequence of ndarray, each (H, W)
            Consecutive frames, blank or not.
        z, x : ndarray, shapes (F, d) and (F, 55)
            Their descriptors and estimated poses; NaN for a blank mask.
        tracked : ndarray, shape (F, 55), optional
            A tracker's estimates, which are better: then the prior is around these.
        roots : array-like, shape (F, 3), optional
            Root relative to what the camera looks at, metres; at the origin by default.
        frames_per_second : float, default=15.0

        Returns
        -------
        fit : Fit

        Raises
        ------
        InputError
            If masks have different sizes.
        """
        sizes = sorted({np.shape(mask) for mask in masks})
        if len(sizes) > 1:
            raise InputError(
                f"masks have the sizes {sizes[0]} and {sizes[1]}: fit to masks of one camera, "
                "which have the same size"
            )
        others = self._neighbours.find(z, self.starts)
        mean = np.asarray(x)
        if tracked is not None:
            others, mean = np.concatenate([mean[:, None], others], axis=1), tracked
        return self.for_size(sizes[0], tracked is not None).fit(
            masks, mean, others=others, roots=roots, frames_per_second=frames_per_second
        )

    def stream(
        self, shape: tuple[int, ...], frames_per_second: float = 15.0, *, tracked: bool = False
    ) -> FitterStream:
        """Start fitting live.

        Parameters
        ----------
        shape : tuple of int
            Height and width of the masks.
        frames_per_second : float, default=15.0
        tracked : bool, default=False
            Whether each frame's estimate will be a tracker's.

        Returns
        -------
        stream : FitterStream
        """
        return FitterStream(self.for_size(shape, tracked), frames_per_second=frames_per_second)

    def with_options(self, options: FittingOptions) -> Self:
        """Fit as in training, but for what options say."""
        own = self.fitter
        trained = ChosenOptions(
            True, own.camera_is, own.shape_is, own.whole_take, own.iterations, self.starts,
            own.prior.lasting, own.prior.seconds,
        )  # fmt: skip
        chosen = options.or_those_of(trained)

        def over_time(prior: PosePrior) -> PosePrior:
            return replace(prior, lasting=chosen.lasting, seconds=chosen.seconds)

        changed = replace(
            own, prior=over_time(own.prior), camera_is=chosen.camera,
            shape_is=chosen.shape, whole_take=chosen.whole_take, iterations=chosen.iterations,
        )  # fmt: skip
        tracked = self.tracked_prior and over_time(self.tracked_prior)
        return replace(self, fitter=changed, starts=chosen.starts, tracked_prior=tracked)

    @property
    def usual_iou(self) -> float:
        """Overlap of body and mask in training."""
        return self.fitter.confidence.usual_iou

    def for_size(self, shape: tuple[int, ...], tracked: bool = False) -> BodyFitter:
        """Create the fitter of masks of one size.

        Parameters
        ----------
        shape : tuple of int
            Height and width of the masks.
        tracked : bool, default=False
            Whether fits start from a tracker's estimates.
        """
        fitter = self.fitter
        if tracked and self.tracked_prior is not None:
            fitter = replace(fitter, prior=self.tracked_prior)
        height, width = shape
        if (height, width) == (fitter.camera.height, fitter.camera.width):
            return fitter
        return replace(fitter, camera=replace(fitter.camera, height=height, width=width))

    @cached_property
    def _neighbours(self) -> DistinctNeighbours:
        return DistinctNeighbours(self.z, self.x, ANGLES.distance)

    def to_arrays(self) -> State:
        """Return everything as arrays, numbers and strings."""
        fitter, body = self.fitter, self.fitter.body
        shape = {} if body.shape is None else {"shape": np.array(body.shape)}
        return {
            "z": self.z,
            "x": self.x,
            "starts": self.starts,
            "usual_iou": fitter.confidence.usual_iou,
            **{name: getattr(fitter, name) for name in _CHOICES},
            **prefixed("body", {"kind": body.kind, "level": body.level, **shape}),
            **prefixed("camera", _values_of(fitter.camera)),
            **prefixed("prior", _values_of(fitter.prior)),
            **prefixed("tracked_prior", _values_of(self.tracked_prior)),
            **prefixed("leg_motion", _values_of(fitter.leg_motion)),
            **prefixed("matching", fitter.matching._asdict()),
            "confidence": np.array(fitter.confidence.weights),
        }

    @classmethod
    def from_arrays(cls, state: State) -> Self:
        """Restore a fitter from the result of `to_arrays`."""
        values = unwrapped(state)
        body, camera, prior, tracked_prior, leg_motion, matching = (
            without_prefix(part, values)
            for part in ("body", "camera", "prior", "tracked_prior", "leg_motion", "matching")
        )
        if "shape" in body:
            body["shape"] = body["shape"].tolist()
        fitter = BodyFitter(
            Body(**body), Camera(**camera), PosePrior(**prior), matching=Matching(**matching),
            confidence=Confidence(tuple(values["confidence"].tolist()), values["usual_iou"]),
            leg_motion=LegMotion(**leg_motion) if leg_motion else None,
            **{name: values[name] for name in _CHOICES},
        )  # fmt: skip
        tracked = PosePrior(**tracked_prior) if tracked_prior else None
        own = {name: values[name] for name in ("z", "x", "starts")}
        return cls(fitter, **own, tracked_prior=tracked)


def _values_of(part: Camera | PosePrior | LegMotion | None) -> State:
    """Values of a dataclass's fields that are not None; none of no dataclass."""
    if part is None:
        return {}
    values = {field.name: getattr(part, field.name) for field in fields(part)}
    return {name: value for name, value in values.items() if value is not None}

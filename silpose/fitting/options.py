"""Settings of fitting: whether, with what knowledge, and from how many starts."""

from __future__ import annotations

from dataclasses import dataclass, replace

from silpose.core.parameters import (
    NOT_NEGATIVE_INTEGER,
    POSITIVE,
    POSITIVE_INTEGER,
    PROBABILITY,
    Constraints,
    check_values,
    one_of,
)
from silpose.fitting.body_fitter import Knowledge

_ALLOWED: Constraints = {
    "camera": one_of("known", "estimated"),
    "shape": one_of("known", "estimated"),
    "iterations": POSITIVE_INTEGER,
    "starts": NOT_NEGATIVE_INTEGER,
    "lasting": PROBABILITY,
    "seconds": POSITIVE,
}


@dataclass(frozen=True)
class ChosenOptions:
    """Options of which every one is chosen; those of `FittingOptions`, with their usual values."""

    enabled: bool = False
    camera: Knowledge = "known"
    shape: Knowledge = "known"
    whole_take: bool = True
    iterations: int = 10
    starts: int = 5
    lasting: float = 0.1
    seconds: float = 0.1


@dataclass(frozen=True)
class FittingOptions:
    """What is fitted, and how.

    What is None is as a model was trained, and in training as is usual.

    Attributes
    ----------
    enabled : bool, default=False
        Whether models are trained with a fitter, and poses are fitted to the contours of masks.
    camera : {"known", "estimated"}, optional
        Whether masks were seen by the camera of `silhouette.camera`; otherwise the image's shift
        and scale and the camera's elevation are fitted too. Usually known.
    shape : {"known", "estimated"}, optional
        Whether the person has the shape of `silhouette.body`; otherwise it is fitted to the whole
        take. Usually known.
    whole_take : bool, optional
        Whether frames are fitted together, as poses that follow each other. Usually they are.
    iterations : int, optional
        Gauss-Newton steps of each frame and start, usually 10.
    starts : int, optional
        Training poses with similar silhouettes from which a frame is fitted too, usually 5.
    lasting : float, optional
        Share of the variance of an estimate's errors that lasts through a take, 0 up to 1, as the
        person's own posture does; usually 0.1.
    seconds : float, optional
        Time in which the rest of these errors decays, usually 0.1.

    Raises
    ------
    InputError
        If a value is out of its range.
    """

    enabled: bool = False
    camera: Knowledge | None = None
    shape: Knowledge | None = None
    whole_take: bool | None = None
    iterations: int | None = None
    starts: int | None = None
    lasting: float | None = None
    seconds: float | None = None

    def __post_init__(self) -> None:
        for name, constraint in _ALLOWED.items():
            if (value := getattr(self, name)) is not None:
                check_values(name, constraint, value)

    def or_those_of(self, others: ChosenOptions) -> ChosenOptions:
        """Take over from others what is None."""
        given = {name: value for name, value in vars(self).items() if value is not None}
        return replace(others, **given)

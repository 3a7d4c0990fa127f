"""Settings of fitting: whether, with what knowledge, and from how many starts."""

from __future__ import annotations

from dataclasses import dataclass

from silpose.core.parameters import (
    NOT_NEGATIVE_INTEGER,
    POSITIVE,
    POSITIVE_INTEGER,
    PROBABILITY,
    check_values,
    one_of,
)
from silpose.fitting.body_fitter import Knowledge


@dataclass(frozen=True)
class FittingOptions:
    """What is fitted, and how.

    Attributes
    ----------
    enabled : bool, default=False
        Whether models are trained with a fitter, and poses are fitted to the contours of masks.
    camera : {"known", "estimated"}, default="known"
        Whether masks were seen by the camera of `silhouette.camera`; otherwise the image's shift
        and scale and the camera's elevation are fitted too.
    shape : {"known", "estimated"}, default="known"
        Whether the person has the shape of `silhouette.body`; otherwise it is fitted to the whole
        take.
    whole_take : bool, default=True
        Whether frames are fitted together, as poses that follow each other.
    iterations : int, default=10
        Gauss-Newton steps of each frame and start.
    starts : int, default=5
        Training poses with similar silhouettes from which a frame is fitted too.
    lasting : float, default=0.1
        Share of the variance of an estimate's errors that lasts through a take, 0 up to 1, as the
        person's own posture does.
    seconds : float, default=0.1
        Time in which the rest of these errors decays.

    Raises
    ------
    InputError
        If a value is out of its range.
    """

    enabled: bool = False
    camera: Knowledge = "known"
    shape: Knowledge = "known"
    whole_take: bool = True
    iterations: int = 10
    starts: int = 5
    lasting: float = 0.1
    seconds: float = 0.1

    def __post_init__(self) -> None:
        for name in ("camera", "shape"):
            check_values(name, one_of("known", "estimated"), getattr(self, name))
        check_values("iterations", POSITIVE_INTEGER, self.iterations)
        check_values("starts", NOT_NEGATIVE_INTEGER, self.starts)
        check_values("lasting", PROBABILITY, self.lasting)
        check_values("seconds", POSITIVE, self.seconds)

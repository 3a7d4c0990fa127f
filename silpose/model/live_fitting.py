"""Live: from masks to estimates to fitted poses, one frame after another."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.types import Array
from silpose.fitting import FitterStream
from silpose.model.pose_fitter import PoseFitter


def fitting_stream(
    fitter: PoseFitter,
    describe: Callable[[ArrayLike], Array],
    estimate: Callable[[Array], Array],
    frames_per_second: float,
    *,
    tracked: bool,
) -> Callable[[ArrayLike], tuple[Array, str]]:
    """Start fitting the body to one mask after another.

    Parameters
    ----------
    fitter : PoseFitter
    describe : callable
        From a mask (H, W) to its descriptor (d,), of NaN if the mask is blank.
    estimate : callable
        From a descriptor to a pose (55,) to start from, both of NaN if there is none.
    frames_per_second : float
    tracked : bool
        Whether these estimates are a tracker's.

    Returns
    -------
    step : callable
        From the next mask to its pose (55,) and the state of the fit.
    """
    running: FitterStream | None = None

    def step(mask: ArrayLike) -> tuple[Array, str]:
        nonlocal running
        frame, z = np.asarray(mask), describe(mask)
        if running is None:  # the first mask says how large they are
            running = fitter.stream(frame.shape, frames_per_second, tracked=tracked)
        return running.step(frame, estimate(z))

    return step

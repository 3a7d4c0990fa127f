"""Estimates of training takes by estimators that were not trained on them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from math import ceil

import numpy as np
from sklearn.base import clone

from silpose.core.parallel import parallel_map
from silpose.core.types import Array, Examples
from silpose.regression import Fold, Regressor, folds
from silpose.tracking import Tracker

_FOLDS = 8  # largest number of parts in which takes are left out
_FRAMES = 10_000  # frames, about, that a regressor is fitted to when some are left out


def regressed_left_out(
    regressor: Regressor, train: Examples, groups: Sequence[str] | None = None
) -> list[Array]:
    """Estimate each take by a regressor that was fitted to others.

    Parameters
    ----------
    regressor : Regressor
        Whose settings are used; it is not changed.
    train : sequence of (z, x)
        Descriptors and poses of each take.
    groups : sequence of str, optional
        Group of each take; one group is left out at a time.

    Returns
    -------
    estimates : list of ndarray, each (F, D)
    """
    return _left_out(partial(_regressed, regressor), train, groups)


def tracked_left_out(
    tracker: Tracker, lag: int, train: Examples, groups: Sequence[str] | None = None
) -> list[Array]:
    """Track each take by a tracker that was fitted to others; else as `regressed_left_out`."""
    return _left_out(partial(_tracked, tracker, lag), train, groups)


def _left_out(
    estimates: Callable[[Fold], list[Array]], train: Examples, groups: Sequence[str] | None
) -> list[Array]:
    places = {id(take): k for k, take in enumerate(train)}
    parts = folds(train, most=_FOLDS, groups=groups)
    found = [np.empty(0)] * len(places)
    several = parallel_map(estimates, parts, description="leaving takes out", prefer="threads")
    for part, own in zip(parts, several, strict=True):
        for take, estimated in zip(part.validation, own, strict=True):
            found[places[id(take)]] = estimated
    return found


def _regressed(regressor: Regressor, fold: Fold) -> list[Array]:
    every = ceil(len(fold.z) / _FRAMES)
    fitted: Regressor = clone(regressor).fit(fold.z[::every], fold.x[::every])
    return [fitted.predict(z) for z, _ in fold.validation]


def _tracked(tracker: Tracker, lag: int, fold: Fold) -> list[Array]:
    fitted: Tracker = clone(tracker).fit(fold.train)
    return [fitted.track(z, lag=lag).x for z, _ in fold.validation]

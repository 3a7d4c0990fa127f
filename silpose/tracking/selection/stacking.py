"""Shares of a tracker's estimate that are better regressed on the silhouette alone.

L. Breiman, "Stacked regressions", Machine Learning 1996.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np

from silpose.core.parallel import parallel_map
from silpose.core.pose_space import PoseSpace
from silpose.core.types import Array, Row, Settings
from silpose.regression import Outcome, search
from silpose.tracking.key_pose_tracker import SHARES, KeyPoseTracker
from silpose.tracking.selection.tracker_selection import FittedFold, TrackerSelection

Parts = tuple[Array, Array]
"""Estimates (F, D) on key poses, and what a share of 1 regressed on the silhouette alone adds."""


def choose_shares(
    selection: TrackerSelection,
    method: str,
    tracker: KeyPoseTracker,
    settings: Settings,
    fit: Callable[[Any], KeyPoseTracker],
    fitted: Callable[[], Sequence[FittedFold]],
) -> dict[str, float]:
    """Return the shares of the heading and of the body: those that are given, else stacked.

    Parameters
    ----------
    selection : TrackerSelection
    method : str
    tracker : KeyPoseTracker
        Whose parameters give shares, or None.
    settings : dict
        Chosen already.
    fit : callable
        Maps a fold to a tracker that is fitted to it, with these settings.
    fitted : callable
        Returns the folds that `fit` takes.

    Returns
    -------
    shares : dict
        ``heading_alone`` and ``body_alone``, each from 0 to 1.
    """
    account = partial(_row, selection.space, method, settings)

    def recorded(row: Row) -> Row:
        selection.rows.append(row)
        return row

    given = {name: getattr(tracker, name) for name in SHARES}
    known = {name: share for name, share in given.items() if share is not None}
    if len(known) == len(given):
        if any(known.values()):  # settings were chosen without them
            selection.score_later(
                method,
                lambda: recorded(account(known, _tracked(fit, fitted()))),
            )
        return known

    def stacked() -> dict[str, Any]:
        tracked = _tracked(fit, fitted())
        shares = stacked_shares(tracked) | known
        return {"shares": shares, "row": account(shares, tracked)}

    found = selection.known.recall(stacked, method, "shares", tracker, settings)
    selection.record_error(method, recorded(found["row"]))
    shares: dict[str, float] = found["shares"]
    return shares


def stacked_shares(tracked: Sequence[FittedFold[Parts]]) -> dict[str, float]:
    """Return the shares that leave the least squares on held-out takes.

    The squares of a fold are relative to those that the tracker itself leaves there, so that a
    take that resembles no other does not decide.

    Parameters
    ----------
    tracked : sequence of FittedFold
        With both parts of the estimates of the held-out frames.

    Returns
    -------
    shares : dict
        ``heading_alone`` and ``body_alone``, each from 0 to 1.
    """
    gain, cost = dict.fromkeys(SHARES, 0.0), dict.fromkeys(SHARES, 0.0)
    for fold in tracked:
        local, change = fold.fitted
        for name, columns in SHARES.items():
            off, step = (fold.x_validation - local)[:, columns], change[:, columns]
            left = max(float((off**2).sum()), 1e-12)
            gain[name] += float((step * off).sum()) / left
            cost[name] += float((step**2).sum()) / left
    return {n: min(max(gain[n] / cost[n], 0.0), 1.0) if cost[n] > 0 else 0.0 for n in SHARES}


def _tracked(
    fit: Callable[[Any], KeyPoseTracker], fitted: Sequence[FittedFold]
) -> list[FittedFold[Parts]]:
    """Track the held-out takes of every fold, once for all shares."""
    parts = parallel_map(partial(_parts, fit), fitted, description="stacking", prefer="processes")
    return [FittedFold((), fold.validation, own) for fold, own in zip(fitted, parts, strict=True)]


def _parts(fit: Callable[[Any], KeyPoseTracker], fold: FittedFold) -> Parts:
    tracker = fit(fold)
    local, change = zip(*(tracker.track_separately(z) for z, _ in fold.validation), strict=True)
    return np.concatenate(local), np.concatenate(change)


def _row(
    space: PoseSpace,
    method: str,
    settings: Settings,
    shares: dict[str, float],
    tracked: Sequence[FittedFold[Parts]],
) -> Row:
    """Account for the error that the shares leave on held-out takes."""
    (row,) = search(partial(_score, space), tracked, [{**settings, **shares}], method=method)
    return row


def _score(
    space: PoseSpace, fold: FittedFold[Parts], settings: Sequence[dict[str, Any]]
) -> list[Outcome]:
    local, change = fold.fitted
    found = []
    for setting in settings:
        estimated = local.copy()
        for name, columns in SHARES.items():
            estimated[:, columns] += setting[name] * change[:, columns]
        found.append(Outcome.of(space.distance(fold.x_validation, estimated).mean()))
    return found

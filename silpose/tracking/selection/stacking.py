"""How much of a tracker's estimate is better regressed on the silhouette alone (Breiman 1996)."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from silpose.core.progress import bar
from silpose.tracking.belief_tracker import BeliefTracker
from silpose.tracking.multiple_hypothesis_tracker import MultipleHypothesisTracker
from silpose.tracking.selection.search import Examples, Selection
from silpose.tracking.selection.settings import HypothesesSettings, TrackerSettings

Array = NDArray[np.float64]
AnyTracker = BeliefTracker | MultipleHypothesisTracker

_PARTS = {"heading_alone": slice(0, 2), "body_alone": slice(2, None)}  # columns of a pose


def shares_of(
    method: str,
    settings: TrackerSettings | HypothesesSettings,
    selection: Selection,
    fitted: Callable[[Examples], AnyTracker],
) -> dict[str, float]:
    """Shares of the heading and of the body: those that are given, else stacked.

    Parameters
    ----------
    method : str
        For the selection's account.
    settings : TrackerSettings or HypothesesSettings
    selection, fitted
        As `stacked_shares` has them; what it returns is returned.
    """
    given = {name: getattr(settings, name) for name in _PARTS}
    known = {name: share for name, share in given.items() if share is not None}
    if len(known) == len(given):
        return known
    shares = stacked_shares(selection, fitted) | known
    selection.rows.append({"method": method, **shares})
    return shares


def stacked_shares(
    selection: Selection, fitted: Callable[[Examples], AnyTracker]
) -> dict[str, float]:
    """Shares, of the heading and of the body, that leave the least squares on held-out sequences.

    The squares of a fold count in units of what the tracker itself leaves there: a sequence that
    resembles no other is not to decide.

    Parameters
    ----------
    selection : Selection
    fitted : callable
        From sequences to a tracker fitted to them.

    Returns
    -------
    shares : dict
        ``heading_alone`` and ``body_alone``, each from 0 to 1.
    """
    gain, cost = dict.fromkeys(_PARTS, 0.0), dict.fromkeys(_PARTS, 0.0)
    pairs = selection.folds()
    with bar("stacking", len(pairs)) as advance:
        for learnt, judged in pairs:
            tracker = fitted(learnt)
            true = np.concatenate([x for _, x in judged])
            tracked = _tracked(tracker, judged, 0.0)
            alone = _tracked(tracker, judged, 1.0) - tracked
            for name, columns in _PARTS.items():
                off, step = (true - tracked)[:, columns], alone[:, columns]
                left = max(float((off**2).sum()), 1e-12)
                gain[name] += float((step * off).sum()) / left
                cost[name] += float((step**2).sum()) / left
            advance(1)
    return {n: min(max(gain[n] / cost[n], 0.0), 1.0) if cost[n] > 0 else 0.0 for n in _PARTS}


def _tracked(tracker: AnyTracker, sequences: Examples, share: float) -> Array:
    """Estimates of all frames, if this share is regressed on the silhouette alone."""
    tracker.set_params(heading_alone=share, body_alone=share)
    return np.concatenate([tracker.track(z).x for z, _ in sequences])

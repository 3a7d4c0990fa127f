"""What trackers return, and the states that a track goes through."""

from __future__ import annotations

from dataclasses import dataclass

from silpose.core.types import Array

STATES = ("starting", "tracking", "lost", "recovered")

SETTLED = 0.7  # heading norm from which a start, or a new one, counts as made
UNCERTAIN = 0.3  # heading norm below which a track counts as lost

_SHORT = 0.5  # seconds


@dataclass(frozen=True)
class Track:
    """Estimates of a take.

    Attributes
    ----------
    x : ndarray, shape (F, D)
        Poses.
    state : list of str
        One of `STATES` for each frame.
    beliefs : ndarray, shape (F, K), or None
        Activations of the kernels of a state-sensitive basis: of key poses, where they sum to 1,
        or of training examples, where they need not.
    weights : ndarray, shape (F, k), or None
        Probabilities of the modes, the most probable first; 0 where there are fewer than k.
    means : ndarray, shape (F, k, D), or None
        Poses of the modes.
    """

    x: Array
    state: list[str]
    beliefs: Array | None = None
    weights: Array | None = None
    means: Array | None = None


def over_a_break(state: str, before: str | None, seconds: float) -> str:
    """State of a frame that follows another after some seconds without frames.

    A tracker that saw nothing meanwhile has recovered; after a short break, as of a few dropped
    frames, it goes on tracking.
    """
    kept = before in ("tracking", "recovered") and seconds < _SHORT
    return "tracking" if state == "recovered" and kept else state


def next_state(state: str, lost: bool, heading_norm: float) -> str:
    """Return the state of a track one frame later.

    Parameters
    ----------
    state : str
        One of `STATES`.
    lost : bool
        Whether nothing was seen, or nothing that was expected.
    heading_norm : float
        Norm of the estimated (cos, sin) of the heading: lower for uncertain estimates.
    """
    if state == "starting":
        return "tracking" if heading_norm > SETTLED and not lost else "starting"
    if lost or heading_norm < UNCERTAIN:
        return "lost"
    if state == "lost":
        return "recovered" if heading_norm > SETTLED else "lost"
    return "tracking"

"""Frames from which a tracker locks on by itself: section V-B of the paper, 84 %."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import partial

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray
from sklearn.base import clone

from silpose.core.pose_space import PoseSpace
from silpose.core.progress import bar
from silpose.core.stages import stage
from silpose.core.types import Array, Metrics
from silpose.evaluation import HEADING_LIMIT_DEG, heading_errors
from silpose.experiments.figures import ESTIMATED, NEUTRAL, headline
from silpose.experiments.setup import Components, prepare_tracking, tidy
from silpose.recording import Recording, Result, palette, record_study
from silpose.recording.captions import in_words
from silpose.recording.figure_style import INK, styled
from silpose.tracking import BeliefTracker, belief_tracks, single_pose_tracks

Tracks = Callable[[Array, bool], Iterator[Array]]
"""From descriptors (F, d), and whether time runs backwards, to poses (F - k, D) from each frame."""

LOCKED_SHARE = 0.95  # share of frames with the heading within its limit from which it counts,
SETTLING = 1.0  # from so many seconds after the start


def initialisation(components: Components) -> Result:
    """Start at every frame in turn, track forwards and backwards, and never start again.

    Parameters
    ----------
    components : Components
    """
    training = prepare_tracking(components)
    described, space = training.described, training.described.data.space
    z, x = described.test[0]
    settling = round(SETTLING * described.frames_per_second)
    with stage("tracking"):
        tracker: BeliefTracker = clone(training.tracker).set_params(restart=0.0)
        tracker.fit(described.train)
        trackers: dict[str, Tracks] = {
            "state_sensitive": lambda z, back: single_pose_tracks(
                training.state_sensitive, z, training.ridge.predict(z)
            ),
            "tracker": lambda z, back: belief_tracks(tracker, z, backwards=back),
            "tracker_lag": lambda z, back: belief_tracks(tracker, z, training.lag, backwards=back),
        }
        shares = {}
        with bar("starts", 2 * len(trackers) * len(z)) as advance:
            for method, tracks in trackers.items():
                forwards = _watched(tracks(z, False), advance)
                backwards = _watched(tracks(z[::-1], True), advance)
                shares[method] = shares_within(space, x, forwards, backwards, settling)
    metrics = {
        method: {
            "locked_on": float((share >= LOCKED_SHARE).mean()),
            "within_20deg": float(share.mean()),
        }
        for method, share in shares.items()
    }
    record = partial(
        record_study,
        series=shares,
        title=f"share of frames within {HEADING_LIMIT_DEG:g}° of the heading, by first frame",
        span=(0.0, 1.05),
        frames_per_second=described.frames_per_second,
    )
    headline = training.validation_error("tracker")
    return Result(
        described.data.name,
        metrics,
        rows=[*training.selection.rows, *tidy(metrics)],
        figure=_figure(shares, metrics),
        recording=Recording("tracks that begin at every frame in turn", record),
        headline=headline,
    )


def shares_within(
    space: PoseSpace,
    x: Array,
    forwards: Iterable[Array],
    backwards: Iterable[Array],
    settling: int,
) -> Array:
    """Share of frames whose heading is within its limit, in both directions from each start.

    Parameters
    ----------
    space : PoseSpace
    x : ndarray, shape (F, D)
        True poses.
    forwards, backwards : iterable of ndarray
        Estimates from the first frame on, from the second on, and so forth; and likewise from the
        last frame back.
    settling : int
        Number of frames after a start that do not count.

    Returns
    -------
    shares : ndarray, shape (F,)
        By the frame of the start; NaN where no frame counts.
    """
    met: list[list[NDArray[np.bool_]]] = [[] for _ in x]
    for starts, along, tracks in ((met, x, forwards), (met[::-1], x[::-1], backwards)):
        for k, (start, estimated) in enumerate(zip(starts, tracks, strict=True)):
            errors = heading_errors(space, along[k:], estimated)
            start.append(errors[settling:] <= HEADING_LIMIT_DEG)
    both = map(np.concatenate, met)
    return np.array([own.mean() if len(own) else np.nan for own in both])


def _watched(tracks: Iterator[Array], advance: Callable[[int], None]) -> Iterator[Array]:
    for track in tracks:
        yield track
        advance(1)


@styled
def _figure(shares: Mapping[str, Array], metrics: Metrics) -> Figure:
    figure = Figure(figsize=(11, 1.7 * len(shares) + 1), layout="constrained")
    rows = figure.subplots(len(shares), sharex=True, squeeze=False)[:, 0]
    for axes, (method, share) in zip(rows, shares.items(), strict=True):
        colours = np.where(share >= LOCKED_SHARE, ESTIMATED, NEUTRAL)
        axes.bar(np.arange(len(share)), share, 1.0, color=colours)
        axes.axhline(LOCKED_SHARE, color=INK, lw=0.7)
        axes.set(xlim=(-0.5, len(share) - 0.5), ylim=(0, 1), yticks=(0, 0.5, LOCKED_SHARE))
        locked = metrics[method]["locked_on"]
        axes.set_title(f"{in_words(method)}: {locked:.0%} of starts lock on")
    rows[-1].set_xlabel("first frame of the track")
    figure.supylabel(f"share of frames within {HEADING_LIMIT_DEG:g}° of the heading", fontsize=9.5)
    headline(
        figure, "From which frames does a tracker lock on by itself?",
        f"{palette.NAMES[palette.ESTIMATED].capitalize()}: the heading is right in "
        f"{LOCKED_SHARE:.0%} of the frames, or more, "
        f"from {SETTLING:g} s after the start",
    )  # fmt: skip
    return figure

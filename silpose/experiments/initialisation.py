"""Frames from which a tracker locks on by itself: section V-B of the paper, 84 %."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

import numpy as np
from matplotlib.figure import Figure
from sklearn.base import clone

from silpose.core.pose_space import PoseSpace
from silpose.core.progress import bar
from silpose.core.stages import stage
from silpose.core.types import Array, Metrics
from silpose.evaluation import HEADING_LIMIT_DEG, heading_errors
from silpose.experiments.figures import ESTIMATED, NEUTRAL, headline
from silpose.experiments.setup import Components, prepare_tracking, tidy
from silpose.model import TrackerTraining
from silpose.recording import Recording, Result, record_study
from silpose.recording.captions import in_words
from silpose.recording.figure_style import INK, styled
from silpose.tracking import GIVEN, BeliefTracker

Track = Callable[[Array, bool], Array]
"""From descriptors (F, d), and whether time runs backwards, to poses (F, D)."""

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
        trackers: dict[str, Track] = {
            "state_sensitive": lambda z, back: _state_sensitive(training, z, back),
            "tracker": lambda z, back: tracker.track(z, backwards=back).x,
            "tracker_lag": lambda z, back: tracker.track(z, lag=training.lag, backwards=back).x,
        }
        shares = {}
        with bar("starts", len(trackers) * len(z)) as advance:
            for method, track in trackers.items():
                shares[method] = np.full(len(z), np.nan)
                for start in range(len(z)):
                    shares[method][start] = share_within(space, z, x, start, settling, track)
                    advance(1)
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


def share_within(
    space: PoseSpace, z: Array, x: Array, start: int, settling: int, track: Track
) -> float:
    """Share of frames whose heading is within its limit, in both directions from a start.

    Parameters
    ----------
    space : PoseSpace
    z, x : ndarray, shapes (F, d) and (F, D)
        Descriptors and true poses.
    start, settling : int
        First frame, and the number of frames after it that do not count.
    track : callable
    """
    met = []
    for part, back in ((slice(start, None), False), (slice(None, start + 1), True)):
        if len(x[part]) > settling:
            errors = heading_errors(space, x[part], track(z[part], back))
            met.append((errors[:-settling] if back else errors[settling:]) <= HEADING_LIMIT_DEG)
    return float(np.concatenate(met).mean()) if met else np.nan


def _state_sensitive(training: TrackerTraining, z: Array, back: bool) -> Array:
    """Track by the paper's tracker from the single-image estimates of the first two frames."""
    along = z[::-1] if back else z
    x = training.state_sensitive.track(along, training.ridge.predict(along[:GIVEN])).x
    return x[::-1] if back else x


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
        f"Orange: the heading is right in {LOCKED_SHARE:.0%} of the frames, or more, "
        f"from {SETTLING:g} s after the start",
    )  # fmt: skip
    return figure

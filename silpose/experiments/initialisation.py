"""From which frames does a tracker find its way by itself? Section V-B of the paper: 84 %."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray
from sklearn.base import clone

from silpose.core.pose_space import PoseSpace
from silpose.core.progress import bar
from silpose.evaluation import heading_errors
from silpose.experiments.setup import Components
from silpose.model.tracker_training import TrackerTraining, learn_to_track
from silpose.model.training import tidy
from silpose.recording import record_study
from silpose.recording.runs.run_folder import Run
from silpose.tracking import BeliefTracker

Array = NDArray[np.float64]
Follow = Callable[[Array, bool], Array]

LOCKED_DEG = 20.0  # heading error within which a track counts as locked on,
LOCKED_SHARE = 0.95  # in this share of the frames,
SETTLING = 1.0  # from so many seconds after the start


def initialisation(rooms: Components, run: Run) -> None:
    """Start at every frame in turn, track forwards and backwards, and never recover.

    Parameters
    ----------
    rooms : Components
    run : Run
    """
    learnt = learn_to_track(rooms, run)
    described, space = learnt.described, learnt.described.data.space
    z, x = described.test[0]
    rate = described.data.test[0].frames_per_second
    settling = round(SETTLING * rate)
    with run.stage("tracking"):
        tracker: BeliefTracker = clone(learnt.tracker).set_params(restart=0.0).fit(described.train)
        followers: dict[str, Follow] = {
            "joint": lambda z, back: _point(learnt, z, back),
            "tracker": lambda z, back: tracker.track(z, backwards=back).x,
            "tracker_lag": lambda z, back: tracker.track(z, lag=learnt.lag, backwards=back).x,
        }
        shares = {}
        with bar("starts", len(followers) * len(z)) as advance:
            for method, follow in followers.items():
                shares[method] = np.full(len(z), np.nan)
                for start in range(len(z)):
                    shares[method][start] = _share_within(space, z, x, start, settling, follow)
                    advance(1)
    metrics = {
        method: {
            "locked_on": float((share >= LOCKED_SHARE).mean()),
            "within_20deg": float(share.mean()),
        }
        for method, share in shares.items()
    }
    with run.writing("initialisation.png") as path:
        _figure(path, shares, metrics)
    record_study(
        run.header("tracks that begin at every frame in turn", metrics),
        run.folder / "initialisation.png",
        shares,
        "share of frames within 20° of the heading, by first frame",
        rate,
    )
    run.write_settings()
    run.write_results([*learnt.selection.rows, *tidy(metrics)])
    run.write_metrics(described.data.name, rooms.seed, metrics)


def _share_within(
    space: PoseSpace,
    z: Array,
    x: Array,
    start: int,
    settling: int,
    follow: Follow,
) -> float:
    """Share of frames whose heading is met, from a second after the start, in both directions."""
    met = []
    for part, back in ((slice(start, None), False), (slice(None, start + 1), True)):
        if len(x[part]) > settling:
            off = heading_errors(space, x[part], follow(z[part], back))
            met.append((off[:-settling] if back else off[settling:]) <= LOCKED_DEG)
    return float(np.concatenate(met).mean()) if met else np.nan


def _point(learnt: TrackerTraining, z: Array, back: bool) -> Array:
    """Track by the paper's tracker from the single-image estimates of the first two frames."""
    along = z[::-1] if back else z
    x = learnt.joint.track(along, learnt.ridge.predict(along[:2]))[0]
    return x[::-1] if back else x


def _figure(path: Path, shares: dict[str, Array], metrics: dict[str, dict[str, float]]) -> None:
    figure = Figure(figsize=(10, 2 * len(shares)), layout="constrained")
    rows = figure.subplots(len(shares), sharex=True, squeeze=False)[:, 0]
    for axes, (method, share) in zip(rows, shares.items(), strict=True):
        locked = share >= LOCKED_SHARE
        axes.bar(np.arange(len(share)), share, 1.0, color=np.where(locked, "#2f8fd0", "#c0392b"))
        axes.axhline(LOCKED_SHARE, color="black", lw=0.7)
        axes.set(ylim=(0, 1), ylabel="share within 20°")
        axes.set_title(
            f"{method}: {metrics[method]['locked_on']:.0%} of starts lock on", fontsize=10
        )
    rows[-1].set_xlabel("first frame")
    figure.savefig(path, dpi=110, format="png")

"""Several hypotheses over time, without any given pose: section VI of the paper."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace
from silpose.core.progress import bar
from silpose.evaluation.recovery import BACK_DEG, FailureSequence, Follow, blanks, cuts
from silpose.experiments.figures import ESTIMATED, QUIET, TRUE
from silpose.experiments.setup import Components
from silpose.model.tracker_training import TrackerTraining, learn_to_track
from silpose.model.training import tidy
from silpose.recording import Truth, record_hypotheses
from silpose.recording.palette import STATES
from silpose.recording.runs.run_folder import Run
from silpose.regression import MixtureOfRegressors
from silpose.tracking import Estimate, ManyTracks, MultipleHypothesisTracker, choose_hypotheses

Array = NDArray[np.float64]

SOON = 1.0  # seconds after a failure within which a tracker is to be back


def hypotheses(rooms: Components, run: Run, blank_frames: int, trials: int) -> None:
    """Track unseen sequences from no given pose, then with failures put in.

    Beside it stand the paper's state-sensitive tracker and the one of a belief over key poses,
    given the first two true poses; these frames count for none. The latter starts by itself, too.

    Parameters
    ----------
    rooms : Components
    run : Run
    blank_frames : int
        How long a silhouette is missing.
    trials : int
        Failures of each kind.
    """
    learnt = learn_to_track(rooms, run)
    described, space = learnt.described, learnt.described.data.space
    with run.stage("regression"):
        mixture, rows = described.learn_mixture(rooms.candidates.mixture, learnt.ridge)
    with run.stage("tracking"):
        settings = rooms.tracking.hypotheses
        tracker = choose_hypotheses(learnt.selection, settings, mixture, learnt.dynamics)
        estimators: dict[str, Estimate] = {
            "ridge": lambda z, _: learnt.ridge.predict(z),
            "mixture_top1": lambda z, _: mixture.predict(z),
            "joint": lambda z, start: learnt.joint.track(z, start)[0],
            "tracker": lambda z, _: learnt.tracker.track(z).x,
            "tracker_given_start": lambda z, start: learnt.tracker.track(z, start).x,
            "hypotheses": lambda z, _: tracker.track(z).x,
            "hypotheses_lag": lambda z, _: tracker.track(z, lag=learnt.lag).x,
        }
        tracks = learnt.follow(estimators)
    with run.stage("failures"):
        seconds = _seconds_lost(rooms, learnt, tracker, blank_frames, trials)
    with run.stage("evaluation"):
        metrics = learnt.measure(tracks)
        for method, kinds in seconds.items():
            back = {f"back_after_{k}": float((s <= SOON).mean()) for k, s in kinds.items()}
            metrics[method] |= back
    film = FailureSequence.of(described.data.test[0], described.test[0][0], blank_frames)
    many = tracker.track(film.z)
    model = replace(described.model(learnt.ridge), tracker=tracker)
    with run.writing("model.npz") as path:
        model.save(path)
    with run.writing("hypotheses.png") as path:
        _figure(path, space, film, mixture, many, seconds)
    _record(rooms, run, film, mixture, many, space, metrics)
    run.write_settings()
    run.write_results([*rows, *learnt.selection.rows, *_lost(seconds), *tidy(metrics)])
    run.write_metrics(described.data.name, rooms.seed, metrics)


def _seconds_lost(
    rooms: Components,
    learnt: TrackerTraining,
    tracker: MultipleHypothesisTracker,
    blank_frames: int,
    trials: int,
) -> dict[str, dict[str, Array]]:
    """Seconds until each tracker is back after each failure, by method and kind."""
    described, rate = learnt.described, learnt.selection.frames_per_second
    failures = {
        "blank": blanks(described.test, blank_frames, trials, rate),
        "cut": cuts(described.test, trials, rate, rooms.seed),
    }
    followers: dict[str, Follow] = {
        "tracker": lambda z: learnt.tracker.track(z).x,
        "hypotheses": lambda z: tracker.track(z).x,
    }
    seconds: dict[str, dict[str, Array]] = {method: {} for method in followers}
    with bar("failures", len(followers) * sum(map(len, failures.values()))) as advance:
        for method, follow in followers.items():
            for kind, several in failures.items():
                lost = []
                for trial in several:
                    lost.append(trial.seconds(described.data.space, follow, rate))
                    advance(1)
                if lost:  # else the sequences are too short
                    seconds[method][kind] = np.array(lost)
    return seconds


def _record(
    rooms: Components,
    run: Run,
    film: FailureSequence,
    mixture: MixtureOfRegressors,
    many: ManyTracks,
    space: PoseSpace,
    metrics: Mapping[str, Mapping[str, float]],
) -> None:
    take, z = film.take, film.z
    weights, means, _ = mixture.predict_modes(np.nan_to_num(z), many.weights.shape[1])
    weights[np.isnan(z).any(axis=1)] = 0
    errors = {
        "mixture_top1": space.distance(take.x, means[:, 0]),
        "hypotheses": space.distance(take.x, many.x),
    }
    told = f"{take.name} by {take.performer}, with blank frames and a cut put in"
    with run.stage("recording"):
        record_hypotheses(
            run.header(told, metrics),
            take,
            Truth.of(take, rooms.camera, errors, space),
            (weights, means),
            many,
            space,
        )


def _lost(seconds: Mapping[str, Mapping[str, Array]]) -> list[dict[str, object]]:
    return [
        {"method": method, "failure": kind, "trial": trial, "seconds_to_come_back": float(lost)}
        for method, kinds in seconds.items()
        for kind, several in kinds.items()
        for trial, lost in enumerate(several)
    ]


def _figure(
    path: Path,
    space: PoseSpace,
    film: FailureSequence,
    mixture: MixtureOfRegressors,
    many: ManyTracks,
    seconds: Mapping[str, Mapping[str, Array]],
) -> None:
    """Heading with failures put in, the tracker's state, and how soon it is back."""
    figure = Figure(figsize=(13, 5), layout="constrained")
    grid = figure.add_gridspec(1, 2, width_ratios=[2.6, 1])
    left, right = figure.add_subfigure(grid[0]), figure.add_subfigure(grid[1])
    headings, states = left.subplots(2, sharex=True, height_ratios=[6, 1])
    take, z, seen = film.take, film.z, ~np.isnan(film.z).any(axis=1)
    frames = np.arange(len(z))
    alone = space.heading(mixture.predict(z[seen]))
    headings.plot(frames, space.heading(take.x), ".", color=TRUE, ms=5, label="true")
    headings.plot(frames[seen], alone, "x", color=QUIET, ms=4, label="one silhouette alone")
    headings.plot(frames, space.heading(many.x), ".", color=ESTIMATED, ms=3, label="tracker")
    headings.axvspan(*frames[~seen][[0, -1]] + (-0.5, 0.5), color="#dddddd", label="blank")
    headings.axvline(film.cut - 0.5, color="black", lw=1, label="cut")
    headings.set(ylim=(-185, 185), yticks=(-180, -90, 0, 90, 180), ylabel="heading, degrees")
    headings.legend(fontsize=8, ncols=5, loc="lower left")
    for state, shade in STATES.items():
        own = frames[np.array(many.state) == state]
        states.bar(own, 1, 1.0, color=np.divide(shade, 255), label=state)
    states.set(yticks=[], xlabel="frame", xlim=(0, len(z)))
    states.legend(fontsize=8, ncols=4, loc="center left")
    axes = right.subplots()
    for method, colour in (("tracker", QUIET), ("hypotheses", ESTIMATED)):
        for kind, style in (("blank", "-"), ("cut", "--")):
            lost = seconds[method].get(kind)
            if lost is not None:
                axes.ecdf(np.minimum(lost, 9), color=colour, ls=style, label=f"{method}: {kind}")
    axes.axvline(SOON, color="black", lw=0.7)
    axes.set(xlim=(0, 1.5), ylim=(0, 1), xlabel="seconds after a failure")
    axes.set_ylabel(f"share of tracks within {BACK_DEG:.0f}° again")
    if axes.lines[1:]:
        axes.legend(fontsize=8, loc="lower right")
    figure.savefig(path, dpi=110, format="png")

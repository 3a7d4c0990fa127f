"""Several hypotheses over time, without any given pose: section VI of the paper."""

from __future__ import annotations

from functools import partial

import numpy as np
from matplotlib.figure import Figure, SubFigure

from silpose.core.pose_space import PoseSpace
from silpose.core.progress import bar
from silpose.core.stages import stage, timed
from silpose.core.types import Array, Row
from silpose.evaluation import HEADING_LIMIT_DEG, FailureSequence, blank_trials, cut_trials
from silpose.experiments.figures import (
    ESTIMATED,
    NEUTRAL,
    SERIES,
    headline,
    legend_above,
    plot_headings,
)
from silpose.experiments.setup import (
    MODES_SHOWN,
    Components,
    fitter_of_model,
    prepare_tracking,
    tidy,
)
from silpose.model import TrackerTraining
from silpose.recording import (
    GroundTruth,
    Header,
    Recording,
    Result,
    palette,
    record_hypotheses,
)
from silpose.recording.captions import in_words
from silpose.recording.figure_style import HAIRLINE, INK, styled
from silpose.regression import MixtureOfRegressors
from silpose.silhouette import Camera
from silpose.tracking import Track

SOON = 1.0  # seconds after a failure within which a tracker should have recovered

Seconds = dict[str, dict[str, Array]]
"""Seconds until recovery from each failure, by method and kind of failure."""


def hypotheses(components: Components, *, blank_frames: int = 20, trials: int = 40) -> Result:
    """Track unseen takes from no given pose, then with injected failures.

    Beside it stand the paper's state-sensitive tracker and the one of a belief over key poses,
    given the first two true poses; these frames count for none. The latter starts by itself, too.

    Parameters
    ----------
    components : Components
    blank_frames : int, default=20
        Number of frames without a silhouette.
    trials : int, default=40
        Number of failures of each kind.
    """
    training = prepare_tracking(components)
    mixture, tracker = training.mixture.mixture, training.hypotheses
    tracks = training.follow(
        {
            "ridge": lambda z, _: training.ridge.predict(z),
            "mixture_top1": lambda z, _: mixture.predict(z),
            "state_sensitive": lambda z, start: training.state_sensitive.track(z, start).x,
            "tracker": lambda z, _: training.tracker.track(z).x,
            "tracker_given_start": lambda z, start: training.tracker.track(z, start).x,
            "hypotheses": lambda z, _: tracker.track(z).x,
            "hypotheses_lag": lambda z, _: tracker.track(z, lag=training.lag).x,
        }
    )
    seconds = _recovery_seconds(training, blank_frames, trials, components.seed)
    metrics = training.measure(tracks)
    for method, kinds in seconds.items():
        back = {f"back_after_{k}": float((s <= SOON).mean()) for k, s in kinds.items()}
        metrics[method] |= back
    described = training.described
    sequence = FailureSequence.of(described.data.test[0], described.test[0][0], blank_frames)
    with stage("tracking"):
        track = tracker.track(sequence.z, modes=MODES_SHOWN)
    take, space = sequence.take, described.data.space
    headline = training.validation_error("hypotheses")
    fitter = fitter_of_model(components, described, training.ridge)
    return Result(
        described.data.name,
        metrics,
        rows=[
            *training.mixture.rows,
            *training.selection.rows,
            *_trial_rows(seconds),
            *tidy(metrics),
        ],
        figure=_figure(space, sequence, mixture, track, seconds),
        recording=Recording(
            f"Shown: {take.title}, with blank frames and, at frame {sequence.cut}, a cut injected",
            partial(_record, space, sequence, mixture, track, take.camera_or(components.camera)),
        ),
        model=described.model(training.ridge, tracker, fitter),
        headline=headline,
    )


@timed("failures")
def _recovery_seconds(
    training: TrackerTraining, blank_frames: int, trials: int, seed: int
) -> Seconds:
    """Seconds until each tracker has recovered from each failure, by method and kind."""
    test, space = training.described.test, training.described.data.space
    rate = training.selection.frames_per_second
    failures = {
        "blank": blank_trials(test, blank_frames, trials, rate),
        "cut": cut_trials(test, trials, rate, seed),
    }
    trackers = {
        "tracker": lambda z: training.tracker.track(z).x,
        "hypotheses": lambda z: training.hypotheses.track(z).x,
    }
    seconds: Seconds = {method: {} for method in trackers}
    with bar("failures", len(trackers) * sum(map(len, failures.values()))) as advance:
        for method, track in trackers.items():
            for kind, several in failures.items():
                lost = []
                for trial in several:
                    lost.append(trial.recovery_seconds(space, track, rate))
                    advance(1)
                if lost:  # else the takes are too short
                    seconds[method][kind] = np.array(lost)
    return seconds


def _trial_rows(seconds: Seconds) -> list[Row]:
    return [
        {"method": method, "failure": kind, "trial": trial, "recovery_seconds": float(lost)}
        for method, kinds in seconds.items()
        for kind, several in kinds.items()
        for trial, lost in enumerate(several)
    ]


def _record(
    space: PoseSpace,
    sequence: FailureSequence,
    mixture: MixtureOfRegressors,
    track: Track,
    camera: Camera,
    header: Header,
) -> None:
    """Record the modes of each silhouette, and those of the tracker, with failures injected."""
    take, z = sequence.take, sequence.z
    weights, means, _ = mixture.predict_modes(np.nan_to_num(z), MODES_SHOWN)
    weights[np.isnan(z).any(axis=1)] = 0
    errors = {
        "mixture_top1": space.distance(take.x, means[:, 0]),
        "hypotheses": space.distance(take.x, track.x),
    }
    truth = GroundTruth.of(take, camera, errors, space)
    modes = weights, means
    record_hypotheses(header, take, truth, modes, track, space, cuts=[sequence.cut])


@styled
def _figure(
    space: PoseSpace,
    sequence: FailureSequence,
    mixture: MixtureOfRegressors,
    track: Track,
    seconds: Seconds,
) -> Figure:
    """Heading with failures injected, the tracker's state, and how soon it recovers."""
    figure = Figure(figsize=(13, 5.8), layout="constrained")
    grid = figure.add_gridspec(1, 2, width_ratios=[2.6, 1])
    left, right = figure.add_subfigure(grid[0]), figure.add_subfigure(grid[1])
    headings, states = left.subplots(2, sharex=True, height_ratios=[6, 1])
    z, seen = sequence.z, ~np.isnan(sequence.z).any(axis=1)
    frames = np.arange(len(z))
    alone = space.heading(mixture.predict(z[seen]))
    headings.plot(frames[seen], alone, "x", color=NEUTRAL, ms=4, label="single image")
    true = sequence.take.x.copy()
    true[sequence.cut] = np.nan  # a gap
    plot_headings(headings, space, true, track.x, label="hypotheses")
    headings.axvspan(
        *frames[~seen][[0, -1]] + (-0.5, 0.5), color=HAIRLINE, lw=0, label="blank masks"
    )
    headings.axvline(sequence.cut - 0.5, color=INK, lw=1, ls="--", label="cut")
    legend_above(headings)
    colours = {state: palette.hexed(colour) for state, colour in palette.STATES.items()}
    states.bar(frames, 1, 1.0, color=[colours[state] for state in track.state])
    for state, colour in colours.items():
        states.bar(0, 0, color=colour, label=state)  # in the legend, even if it never occurs
    states.set(ylim=(0, 1), yticks=[], xlabel="frame", xlim=(-0.5, len(z) - 0.5), ylabel="state")
    legend_above(states)
    _plot_recovery(right, seconds)
    headline(figure, "Several hypotheses find the track by themselves, and again after failures")
    return figure


def _plot_recovery(figure: SubFigure, seconds: Seconds) -> None:
    axes = figure.subplots()
    for method, colour in (("tracker", SERIES[0]), ("hypotheses", ESTIMATED)):
        for kind, style in (("blank", "-"), ("cut", "--")):
            lost = seconds[method].get(kind)
            if lost is not None:
                label = f"{in_words(method)}, after {'blank masks' if kind == 'blank' else 'a cut'}"
                axes.ecdf(np.minimum(lost, 9), color=colour, ls=style, lw=2, label=label)
    axes.axvline(SOON, color=INK, lw=0.7)
    axes.set(xlim=(-0.03, 1.5), ylim=(0, 1.01), xlabel="seconds after the failure")
    axes.set_ylabel(f"share of tracks with the heading within {HEADING_LIMIT_DEG:.0f}°")
    if axes.lines[1:]:
        figure.legend(*axes.get_legend_handles_labels(), loc="outside upper right")

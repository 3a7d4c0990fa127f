"""Dynamics alone, observation alone, both together: section V of the paper, Figs. 14, 15."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial

from matplotlib.figure import Figure

from silpose.core.pose_space import PoseSpace
from silpose.core.types import Array
from silpose.evaluation import thigh_swing
from silpose.experiments.figures import ESTIMATED, TRUE, headline, plot_headings, with_unit
from silpose.experiments.setup import Components, fitter_of_model, prepare_tracking, tidy
from silpose.recording import GroundTruth, Recording, Result, record_tracking
from silpose.recording.captions import in_words
from silpose.recording.figure_style import styled
from silpose.tracking import GIVEN

SHOWN = {
    "dynamics": "dynamics alone",
    "ridge": "observation alone",
    "state_sensitive": "both, as one pose",
    "tracker": "both, as a belief",
    "tracker_lag": "a belief, with a lag",
}


def tracking(components: Components) -> Result:
    """Track a person through unseen takes, beside all baselines that smooth.

    The trackers that carry a single pose are given the first two true ones, as in the paper; the
    belief trackers start by themselves. These two frames count for no method.

    Parameters
    ----------
    components : Components
    """
    training = prepare_tracking(components)
    tracker, described = training.tracker, training.described
    estimators = {
        "ridge": lambda z, _: training.ridge.predict(z),
        **training.baselines,
        "dynamics": lambda z, start: training.dynamics.run(start, len(z)),
        "state_sensitive": lambda z, start: training.state_sensitive.track(z, start).x,
        "tracker": lambda z, _: tracker.track(z).x,
        "tracker_lag": lambda z, _: tracker.track(z, lag=training.lag).x,
    }
    tracks = training.follow(estimators)
    metrics = training.measure(tracks)
    metrics["state_sensitive"]["kept"] = training.state_sensitive.regressor_.kept_
    metrics["tracker"]["kept"] = metrics["tracker_lag"]["kept"] = tracker.kept_
    take, space = described.data.test[0], described.data.space
    first = {method: of_takes[0] for method, of_takes in tracks.items()}
    errors = {method: space.distance(take.x, x) for method, x in first.items()}
    record = partial(
        record_tracking,
        take=take,
        truth=GroundTruth.of(take, take.camera_or(components.camera), errors, space),
        tracks={m: first[m] for m in ("ridge", "dynamics", "state_sensitive", "tracker")},
        track=tracker.track(described.test[0][0]),
        facing=space.heading(tracker.examples_.headings),
        space=space,
    )
    headline = training.validation_error("tracker")
    fitter = fitter_of_model(components, described, training.ridge, training.tracker)
    return Result(
        described.data.name,
        metrics,
        rows=[*training.selection.rows, *tidy(metrics)],
        figure=_figure(space, take.x, first),
        recording=Recording(f"Shown: {take.title}", record),
        model=described.model(training.ridge, tracker, fitter),
        headline=headline,
    )


@styled
def _figure(space: PoseSpace, true: Array, tracks: Mapping[str, Array]) -> Figure:
    """Left thigh and heading over time: columns as in Fig. 14, and two more for the belief."""
    figure = Figure(figsize=(14, 5.4), layout="constrained")
    rows = figure.subplots(2, len(SHOWN), sharex=True, sharey="row")
    for (swings, headings), (method, title) in zip(rows.T, SHOWN.items(), strict=True):
        x = tracks[method]
        swings.plot(thigh_swing(space, true), color=TRUE, lw=3, alpha=0.7, label="true")
        swings.plot(thigh_swing(space, x), color=ESTIMATED, lw=1.2, label="estimated")
        swings.set(ylim=(-90, 90), yticks=(-90, -45, 0, 45, 90), xlim=(0, len(true) - 1))
        error = space.distance(true[GIVEN:], x[GIVEN:]).mean()
        swings.set_title(f"{title}\nerror {with_unit(error, space.metrics[0])}")
        plot_headings(headings, space, true, x)
        headings.set(xlabel="frame", ylabel="")
    rows[0, 0].set_ylabel("left thigh, degrees")
    rows[1, 0].set_ylabel("heading, degrees")
    figure.legend(*rows[0, 0].get_legend_handles_labels(), loc="outside upper right", ncols=2)
    headline(
        figure, "What do dynamics add to what is seen?", f"Errors: {in_words(space.metrics[0])}"
    )
    return figure

"""How far to follow the dynamics: C = sI for several s. Section V-A of the paper, Fig. 13."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from matplotlib.figure import Figure

from silpose.core.parallel import parallel_map
from silpose.core.parameters import FROM_0_TO_1, check_values
from silpose.core.stages import stage
from silpose.core.types import Metrics
from silpose.experiments.figures import NEUTRAL, headline, legend_above
from silpose.experiments.setup import Components, prepare_tracking, tidy
from silpose.model import TrackerTraining
from silpose.recording import Recording, Result, palette, record_study
from silpose.recording.captions import coloured, in_words
from silpose.recording.figure_style import styled
from silpose.tracking import Estimate, SinglePoseTracker

FULL = "full C"
COLOUR = palette.METHODS["state_sensitive"]
LINE = palette.hexed(COLOUR)


def damping(
    components: Components, *, values: Sequence[float] = (0, 0.7, 0.8, 0.85, 0.9, 0.95, 0.98, 1)
) -> Result:
    """Track with the paper's regressor under several linear terms.

    The two poses that it is given count for none of them.

    Parameters
    ----------
    components : Components
    values : sequence of float, default=(0, 0.7, 0.8, 0.85, 0.9, 0.95, 0.98, 1)
        Damping factors s; the full matrix C stands beside them.
    """
    check_values("values", FROM_0_TO_1, *values)
    training = prepare_tracking(components)
    with stage("tracking"):
        linear = {f"s={s:g}": s for s in sorted(values)} | {FULL: None}
        trackers = parallel_map(
            partial(_tracker, training), list(linear.values()), description="C", prefer="threads"
        )
        estimates = map(_estimate, trackers)
        tracks = training.follow(dict(zip(linear, estimates, strict=True)))
    metrics = training.measure(tracks)
    data = training.described.data
    take, space = data.test[0], data.space
    record = partial(
        record_study,
        series={name: space.distance(take.x, of_takes[0]) for name, of_takes in tracks.items()},
        title=in_words(space.metrics[0]),
        legend=f"{coloured({'C = sI': COLOUR, FULL: palette.NEUTRAL})}; the larger s, the darker",
        frames_per_second=take.frames_per_second,
        colours={
            name: palette.NEUTRAL if name == FULL else palette.graded(COLOUR, k, len(values))
            for k, name in enumerate(linear)
        },
    )
    headline = training.validation_error("state_sensitive")
    return Result(
        data.name,
        metrics,
        rows=[*training.selection.rows, *tidy(metrics)],
        figure=_figure(sorted(values), metrics, space.metrics[0]),
        recording=Recording("C = sI, and the full matrix C", record),
        headline=headline,
    )


def _tracker(training: TrackerTraining, linear: float | None) -> SinglePoseTracker:
    return training.state_sensitive_with(linear=linear)


def _estimate(tracker: SinglePoseTracker) -> Estimate:
    return lambda z, start: tracker.track(z, start).x


@styled
def _figure(values: Sequence[float], metrics: Metrics, metric: str) -> Figure:
    figure = Figure(figsize=(8, 4.6), layout="constrained")
    axes = figure.subplots()
    errors = [metrics[f"s={s:g}"][metric] for s in values]
    axes.plot(values, errors, "o-", color=LINE, label="C = sI", clip_on=False)
    axes.axhline(metrics[FULL][metric], color=NEUTRAL, ls="--", lw=2, label="the full matrix C")
    axes.set(xlabel="damping factor s", ylabel=in_words(metric), xlim=(0, 1.01), ylim=(0, None))
    legend_above(axes)
    headline(
        figure, "How far to follow the dynamics?",
        "The paper's tracker, with a linear term of the predicted pose that is damped by s",
    )  # fmt: skip
    return figure

"""A pose kernel that is too narrow loses the track: section V-A of the paper, Fig. 12."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial

import numpy as np
from matplotlib.figure import Figure

from silpose.core.parameters import POSITIVE, POSITIVE_INTEGER, check_values
from silpose.core.pose_space import PoseSpace
from silpose.core.stages import stage
from silpose.core.types import Array
from silpose.evaluation import thigh_swing
from silpose.experiments.figures import ESTIMATED, TRUE, headline, with_unit
from silpose.experiments.setup import Components, prepare_tracking, tidy
from silpose.recording import Recording, Result, record_extinction
from silpose.recording.figure_style import styled
from silpose.tracking import EXTINCT, GIVEN, SinglePoseTracker


def extinction(
    components: Components,
    *,
    kernels: int = 120,
    narrower: Sequence[float] = (3, 10),
    takes: Sequence[str] = ("train_5",),
) -> Result:
    """Track with the pose kernel of chosen width, and with ones that are too narrow.

    Parameters
    ----------
    components : Components
    kernels : int, default=120
        Number of training examples that carry a kernel, drawn by seed.
    narrower : sequence of float, default=(3, 10)
        Divisors of the kernel's width: β_x is multiplied by their squares.
    takes : sequence of str, default=("train_5",)
        Training takes of the kernels; by default the paper's, which ``dataset=agarwal`` has. Where
        the dataset has none of them, its longest.
    """
    check_values("kernels", POSITIVE_INTEGER, kernels)
    check_values("narrower", POSITIVE, *narrower)
    training = prepare_tracking(components)
    described, space = training.described, training.described.data.space
    names = [take.name for take in described.data.train]
    longest = max(range(len(names)), key=lambda k: len(described.train[k][1]))
    named = [k for k, name in enumerate(names) if name in takes] or [longest]
    chosen = training.state_sensitive.regressor_.pose_width
    z, x = described.test[0]
    poses, activations = {}, {}
    with stage("tracking"):
        for factor in (1, *narrower):
            tracker = training.state_sensitive_with(
                [described.train[k] for k in named],
                centres=kernels,
                keep_at_most=None,
                pose_width=chosen * factor**2,
            )
            name = "as chosen" if factor == 1 else f"{factor:g} times narrower"
            track = tracker.track(z, x[:GIVEN])
            assert track.beliefs is not None, "these are the kernels of a tracker of one pose"
            poses[name], activations[name] = track.x, track.beliefs[:, _by_heading(tracker)]
    errors = {name: space.distance(x, estimated) for name, estimated in poses.items()}
    metrics = {
        name: {
            space.metrics[0]: float(errors[name][GIVEN:].mean()),
            "extinct": float((own[GIVEN:].max(axis=1) < EXTINCT).mean()),
        }
        for name, own in activations.items()
    }
    record = partial(
        record_extinction,
        activations=activations,
        errors=errors,
        frames_per_second=described.frames_per_second,
    )
    headline = training.validation_error("state_sensitive")
    return Result(
        described.data.name,
        metrics,
        rows=[*training.selection.rows, *tidy(metrics)],
        figure=_figure(space, x, poses, activations),
        recording=Recording("activations of the kernels over time", record),
        headline=headline,
    )


def _by_heading(tracker: SinglePoseTracker) -> np.ndarray:
    """Order of the kernels in which a walk in a circle meets them: by their poses' headings."""
    regressor = tracker.regressor_
    centres = regressor.centres_x_ * regressor.scale_ + regressor.mean_
    return np.argsort(np.arctan2(centres[:, 1], centres[:, 0]))


@styled
def _figure(
    space: PoseSpace, true: Array, poses: Mapping[str, Array], activations: Mapping[str, Array]
) -> Figure:
    figure = Figure(figsize=(4.4 * len(poses), 5.4), layout="constrained")
    rows = figure.subplots(2, len(poses), sharex=True, sharey="row", squeeze=False)
    highest = max(float(own[GIVEN:].max()) for own in activations.values())
    for (swing, image), (name, x) in zip(rows.T, poses.items(), strict=True):
        swing.plot(thigh_swing(space, true), color=TRUE, lw=3, alpha=0.7, label="true")
        swing.plot(thigh_swing(space, x), color=ESTIMATED, lw=1.2, label="tracked")
        error = space.distance(true[GIVEN:], x[GIVEN:]).mean()
        swing.set_title(f"kernel {name}: error {with_unit(error, space.metrics[0])}")
        swing.set(ylim=(-90, 90), yticks=(-90, -45, 0, 45, 90))
        picture = image.imshow(
            activations[name].T, aspect="auto", vmin=0, vmax=highest, interpolation="nearest"
        )
        image.set_xlabel("frame")
    rows[0, 0].set_ylabel("left thigh, degrees")
    rows[1, 0].set_ylabel("kernels, by heading")
    figure.colorbar(picture, ax=rows[1], label="activation")
    figure.legend(*rows[0, 0].get_legend_handles_labels(), loc="outside upper right", ncols=2)
    headline(
        figure, "A pose kernel that is too narrow loses the track",
        "Below: where no kernel is active (black), nothing that is seen can correct the track",
    )  # fmt: skip
    return figure

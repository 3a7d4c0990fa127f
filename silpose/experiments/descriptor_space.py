"""What do shape contexts and their codebook look like? Section II-A of the paper, Fig. 2."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import hsv_to_rgb
from matplotlib.figure import Figure
from numpy.typing import NDArray

from silpose.core.errors import InputError
from silpose.descriptor import Description
from silpose.descriptor.context_space import ContextSpace
from silpose.experiments.setup import Components, masks_of
from silpose.model.describe import learn_descriptor
from silpose.recording import codebook_picture, record_context_space
from silpose.recording.runs.run_folder import Run

Array = NDArray[np.float64]


def descriptor_space(rooms: Components, run: Run, contexts: int) -> None:
    """Look at all contexts in the plane of their two principal components, and at the codebook.

    Parameters
    ----------
    rooms : Components
    run : Run
    contexts : int
        At most so many contexts of training silhouettes are drawn.
    """
    if contexts < 2:
        raise InputError(f"contexts must be at least 2, not {contexts}")
    with run.stage("masks"):
        data = rooms.dataset()
    take = data.test[0]
    masks = masks_of(take, run)
    with run.stage("descriptors"):
        descriptor = learn_descriptor(rooms.descriptor, data.train)
        assert descriptor is not None, "there are masks"
        training = [mask for each in data.train for mask in masks_of(each, run)]
        rng = np.random.default_rng(rooms.seed)
        few = rng.choice(len(training), min(len(training), 1 + contexts // 50), replace=False)
        cloud = np.concatenate(
            [d.contexts for d in descriptor.describe([training[k] for k in few])]
        )
        cloud = cloud[rng.choice(len(cloud), min(contexts, len(cloud)), replace=False)]
        seen = descriptor.describe(masks)
    space = ContextSpace.of(cloud, descriptor.codebook_, seen)
    metrics = {
        "codebook": {
            "variance_in_plane": float(space.contexts.var(axis=0).sum() / cloud.var(axis=0).sum()),
            "distance_to_nearest": descriptor.vote_width_ / descriptor.vote_width,
            "centres_voted_for": float(np.mean([(d.z > 1e-3 * d.z.sum()).sum() for d in seen])),
        }
    }
    picture = codebook_picture(descriptor.codebook_, descriptor.angular_bins)
    frame = len(take) // 3
    with run.writing("descriptor_space.png") as path:
        _figure(path, space, seen[frame], space.points[frame], masks[frame], picture)
    record_context_space(
        run.header(f"test sequence {take.name} by {take.performer}", metrics),
        masks,
        seen,
        space,
        descriptor.codebook_,
        descriptor.angular_bins,
        take.frames_per_second,
    )
    run.write_settings()
    run.write_results(
        [
            {"centre": k, "component_1": x, "component_2": y}
            for k, (x, y) in enumerate(space.centres)
        ]
    )
    run.write_metrics(data.name, rooms.seed, metrics)


def _figure(
    path: Path,
    space: ContextSpace,
    description: Description,
    points: Array,
    mask: NDArray[np.uint8],
    picture: NDArray[np.uint8],
) -> None:
    hues = np.arange(len(space.centres)) / len(space.centres)
    colours = hsv_to_rgb(np.stack([hues, np.full_like(hues, 0.75), np.full_like(hues, 0.85)], 1))
    figure = Figure(figsize=(13, 4.6), layout="constrained")
    everything, one, person, codebook = figure.subplots(1, 4, width_ratios=[1.15, 1.15, 0.6, 1.05])
    everything.plot(*space.contexts.T, ",", color="0.6")
    x, y = space.centres.T
    everything.scatter(x, y, c=colours, s=28, edgecolors="black", linewidths=0.5)
    everything.set_title("all contexts, and the centres", fontsize=10)
    x, y = points.T
    one.scatter(x, y, c=colours[description.nearest], s=10)
    one.set_title("those of one silhouette", fontsize=10)
    for axes in (everything, one):
        axes.set(xlabel="first component", aspect="equal")
    everything.set_ylabel("second component")
    one.set(xlim=everything.get_xlim(), ylim=everything.get_ylim())
    _silhouette(person, mask, description, colours)
    codebook.imshow(picture)
    codebook.set_title("the centres in log-polar bins", fontsize=10)
    codebook.axis("off")
    figure.savefig(path, dpi=120, format="png")


def _silhouette(
    axes: Axes, mask: NDArray[np.uint8], description: Description, colours: Array
) -> None:
    axes.imshow(1 - 0.2 * mask, cmap="gray", vmin=0, vmax=1)
    x, y = description.points.T
    axes.scatter(x, y, c=colours[description.nearest], s=7)
    axes.set(xlim=(x.min() - 15, x.max() + 15), ylim=(y.max() + 10, y.min() - 10))
    axes.set_title("on the silhouette", fontsize=10)
    axes.axis("off")

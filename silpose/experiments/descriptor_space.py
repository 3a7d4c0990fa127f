"""What shape contexts and their codebook look like: section II-A of the paper, Fig. 2."""

from __future__ import annotations

from functools import partial

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import hsv_to_rgb
from matplotlib.figure import Figure
from numpy.typing import NDArray

from silpose.core.errors import InputError
from silpose.core.stages import stage
from silpose.core.types import Array, Mask
from silpose.descriptor import Description
from silpose.descriptor.context_space import ContextSpace
from silpose.experiments.figures import NEUTRAL, draw_silhouette, headline, without_ink
from silpose.experiments.setup import Components, want_masks
from silpose.model import fit_descriptor
from silpose.recording import Recording, Result, codebook_picture, record_context_space
from silpose.recording.figure_style import INK, styled


def descriptor_space(components: Components, *, contexts: int = 20_000) -> Result:
    """Show contexts in the plane of their two principal components, and the codebook.

    Parameters
    ----------
    components : Components
    contexts : int, default=20_000
        Number of contexts of training silhouettes that are drawn, at most.
    """
    if contexts < 2:
        raise InputError(f"contexts must be at least 2, not {contexts}")
    data = components.load()
    want_masks([*data.train, *data.test], "descriptor_space")
    take = data.test[0]
    masks = take.mask_array()
    with stage("descriptors"):
        descriptor = fit_descriptor(components.descriptor, data.train)
        assert descriptor is not None, "there are masks"
        training = [mask for each in data.train for mask in each.mask_array()]
        rng = np.random.default_rng(components.seed)
        few = rng.choice(len(training), min(len(training), 1 + contexts // 50), replace=False)
        some = descriptor.describe([training[k] for k in few])
        cloud = np.concatenate([description.contexts for description in some])
        cloud = cloud[rng.choice(len(cloud), min(contexts, len(cloud)), replace=False)]
        descriptions = descriptor.describe(masks)
        space = ContextSpace.of(cloud, descriptor.codebook_, descriptions)
    voted_for = [(d.z > 1e-3 * d.z.sum()).sum() for d in descriptions]
    metrics = {
        "codebook": {
            "variance_in_plane": float(space.contexts.var(axis=0).sum() / cloud.var(axis=0).sum()),
            "distance_to_nearest": descriptor.vote_width_ / descriptor.vote_width,
            "centres_voted_for": float(np.mean(voted_for)),
        }
    }
    picture = codebook_picture(descriptor.codebook_, descriptor.angular_bins)
    frame = len(take) // 3
    record = partial(
        record_context_space,
        masks=masks,
        descriptions=descriptions,
        space=space,
        codebook=descriptor.codebook_,
        angular_bins=descriptor.angular_bins,
        frames_per_second=take.frames_per_second,
    )
    return Result(
        data.name,
        metrics,
        rows=[
            {"centre": k, "component_1": x, "component_2": y}
            for k, (x, y) in enumerate(space.centres)
        ],
        figure=_figure(space, descriptions[frame], space.points[frame], masks[frame], picture),
        recording=Recording(f"Shown: {take.title}", record),
    )


@styled
def _figure(
    space: ContextSpace,
    description: Description,
    points: Array,
    mask: Mask,
    picture: NDArray[np.uint8],
) -> Figure:
    hues = np.arange(len(space.centres)) / len(space.centres)
    colours = hsv_to_rgb(np.stack([hues, np.full_like(hues, 0.75), np.full_like(hues, 0.85)], 1))
    own = colours[description.nearest]
    figure = Figure(figsize=(13, 4.5), layout="constrained")
    person, one, everything, codebook = figure.subplots(1, 4, width_ratios=[0.6, 1.1, 1.1, 1.05])
    _draw_points(person, mask, description, own)
    one.scatter(*points.T, c=own, s=10)
    one.set_title("2. their shape contexts")
    everything.plot(*space.contexts.T, ",", color=NEUTRAL)
    everything.scatter(*space.centres.T, c=colours, s=28, edgecolors=INK, linewidths=0.5)
    everything.set_title("3. contexts of all silhouettes, and centres")
    for axes in (one, everything):
        axes.set(xlabel="first principal component", aspect="equal")
    one.set_ylabel("second principal component")
    one.set(xlim=everything.get_xlim(), ylim=everything.get_ylim())
    codebook.imshow(picture)
    codebook.set_title("4. the centres, as log-polar histograms")
    without_ink(codebook)
    headline(
        figure, "What do shape contexts and their codebook look like?",
        "A point has the colour of the codebook's centre that is nearest to its shape context",
    )  # fmt: skip
    return figure


def _draw_points(axes: Axes, mask: Mask, description: Description, colours: Array) -> None:
    draw_silhouette(axes, mask)
    x, y = description.points.T
    axes.scatter(x, y, c=colours, s=8)
    axes.set(xlim=(x.min() - 15, x.max() + 15), ylim=(y.max() + 10, y.min() - 10))
    axes.set_title("1. edge points")
    without_ink(axes)

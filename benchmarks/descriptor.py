"""How many masks a second the descriptor takes: python benchmarks/descriptor.py."""

import sys
from pathlib import Path

import cv2
import numpy as np
from timing import per_second, report

from silpose.config import furnish, load
from silpose.descriptor import ShapeContextHistogram
from silpose.descriptor.boundary import boundary_pixels, spaced_indices
from silpose.descriptor.codebook import soft_votes, squared_distances
from silpose.descriptor.shape_context import ring_bounds, sector_table, shape_contexts

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "descriptor"))
import reference


def rough_masks(count: int) -> list[np.ndarray]:
    """256 x 256 masks that people fill from top to bottom, their outline frayed."""
    overrides = ["silhouette.camera.focal_length=2.5", f"motion.test_seconds={count / 15}"]
    rng = np.random.default_rng(0)
    masks = []
    for mask in furnish(load(overrides)).dataset().test[0].masks:
        edge = mask ^ cv2.erode(mask, np.ones((3, 3), np.uint8))
        masks.append(mask ^ (edge & (rng.random(mask.shape) < 0.08).astype(np.uint8)))
    return masks


def steps(histogram: ShapeContextHistogram, masks: list[np.ndarray]) -> dict[str, float]:
    """Masks a second through each step alone."""
    outlines = [boundary_pixels(mask) for mask in masks]
    chosen = [p[spaced_indices(p, n, histogram.edge_points)] for p, n in outlines]
    bounds = ring_bounds(40, 4, 5)
    sectors = sector_table(64, 12)
    contexts = [
        shape_contexts(p, points, bounds, sectors, 12)
        for (p, _), points in zip(outlines, chosen, strict=True)
    ]
    distances = [squared_distances(c, histogram.codebook_) for c in contexts]
    width = histogram.vote_width_
    work = {
        "cv2.findContours alone": lambda: [
            cv2.findContours(mask, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE) for mask in masks
        ],
        "boundary": lambda: [boundary_pixels(mask) for mask in masks],
        "edge points": lambda: [spaced_indices(p, n, len(chosen[0])) for p, n in outlines],
        "shape contexts": lambda: [
            shape_contexts(p, points, bounds, sectors, 12)
            for (p, _), points in zip(outlines, chosen, strict=True)
        ],
        "distances to the codebook": lambda: [
            squared_distances(c, histogram.codebook_) for c in contexts
        ],
        "soft votes": lambda: [soft_votes(d, histogram.voters, width) for d in distances],
    }
    return {name: per_second(call, len(masks)) for name, call in work.items()}


def in_numpy(histogram: ShapeContextHistogram, masks: list[np.ndarray]) -> float:
    """Masks a second by the same definition in NumPy."""
    descriptions = histogram.describe(masks)

    def describe() -> None:
        for mask, description in zip(masks, descriptions, strict=True):
            pixels = np.concatenate(reference.boundary(mask))
            reach = histogram.radius * np.sqrt(pixels.var(axis=0).sum())
            inner = histogram.inner_radius * reach
            contexts = reference.contexts(pixels, description.points, reach, inner, 12, 5)
            reference.votes(contexts, histogram.codebook_, histogram.voters, histogram.vote_width_)

    return per_second(describe, len(masks), rounds=1)


if __name__ == "__main__":
    masks = rough_masks(200)
    pixels = int(np.mean([len(boundary_pixels(mask)[0]) for mask in masks]))
    histogram = ShapeContextHistogram(n_jobs=1).fit(masks)
    everywhere = ShapeContextHistogram(edge_points=pixels, n_jobs=1).fit(masks)
    rates = {
        "mask to z, 200 edge points": per_second(lambda: histogram.transform(masks), len(masks)),
        f"mask to z, {pixels} edge points": per_second(
            lambda: everywhere.transform(masks), len(masks)
        ),
        "the same in NumPy, 200 edge points": in_numpy(histogram, masks[:20]),
        **{f"  {step}": rate for step, rate in steps(histogram, masks).items()},
    }
    report(
        f"{len(masks)} masks of 256 x 256, {pixels} boundary pixels on average, one core",
        ["what", "masks a second", "µs a mask"],
        [[name, f"{rate:,.0f}", f"{1e6 / rate:,.0f}"] for name, rate in rates.items()],
    )

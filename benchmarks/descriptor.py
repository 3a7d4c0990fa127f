"""Masks described per second: python benchmarks/descriptor.py [--fast]."""

import sys
from pathlib import Path

import cv2
import numpy as np
from timing import FAST, per_second, report

from silpose.dataset import render_take
from silpose.descriptor import ShapeContextHistogram
from silpose.descriptor.boundary import boundary_pixels
from silpose.descriptor.description import EdgeContexts
from silpose.descriptor.subpixel import lattice_boundary
from silpose.descriptor.voting import soft_votes
from silpose.motion import WalkerTakes
from silpose.silhouette import Body, Camera

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "descriptor"))
import reference


def rough_masks(count: int) -> list[np.ndarray]:
    """Masks of 256 x 256 pixels that people fill from top to bottom, with frayed outlines."""
    test = WalkerTakes(test_seconds=count / 15).takes()[-1]
    rng = np.random.default_rng(0)
    masks = []
    for mask in render_take(test, Body(), Camera(focal_length=2.5)).masks:
        edge = mask ^ cv2.erode(mask, np.ones((3, 3), np.uint8))
        masks.append(mask ^ (edge & (rng.random(mask.shape) < 0.08).astype(np.uint8)))
    return masks


def steps(histogram: ShapeContextHistogram, masks: list[np.ndarray]) -> dict[str, float]:
    """Masks per second of each step alone."""
    outlines = [boundary_pixels(mask) for mask in masks]
    extractor = EdgeContexts.of(histogram)
    edges = [extractor.edge(mask) for mask in masks]
    contexts = [description.contexts for description in histogram.describe(masks)]
    centres = np.ascontiguousarray(histogram.codebook_.T)
    norms = (histogram.codebook_**2).sum(axis=1)
    voters, width = histogram.voters, histogram.vote_width_
    work = {
        "cv2.findContours alone, the lower limit": lambda: [
            cv2.findContours(mask, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE) for mask in masks
        ],
        "boundary pixels, with findContours": lambda: [boundary_pixels(mask) for mask in masks],
        "boundary between the pixels, from these": lambda: [lattice_boundary(*o) for o in outlines],
        "mask to edge points": lambda: [extractor.edge(mask) for mask in masks],
        "shape contexts": lambda: [
            extractor.contexts(edge, edge.chosen, extractor.rings(edge)) for edge in edges
        ],
        "soft votes": lambda: [soft_votes(c, centres, norms, voters, width) for c in contexts],
    }
    return {name: per_second(call, len(masks)) for name, call in work.items()}


def in_numpy(histogram: ShapeContextHistogram, masks: list[np.ndarray]) -> float:
    """Masks per second of the definition along pixels, in NumPy."""
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
    masks = rough_masks(30 if FAST else 200)
    pixels = int(np.mean([len(boundary_pixels(mask)[0]) for mask in masks]))
    histogram = ShapeContextHistogram(n_jobs=1).fit(masks)
    along_pixels = ShapeContextHistogram(boundary="pixels", n_jobs=1).fit(masks)
    everywhere = ShapeContextHistogram(edge_points=None, n_jobs=1).fit(masks)
    closed = ShapeContextHistogram(closing=0.07, n_jobs=1).fit(masks)
    all_centres = ShapeContextHistogram(voters=None, n_jobs=1).fit(masks)
    rates = {}
    for name, one in {
        "mask to z, 200 edge points": histogram,
        "mask to z, 200 edge points on pixels": along_pixels,
        "mask to z, all points": everywhere,
        "mask to z, 200 points vote for all centres": all_centres,
        "mask to z, 200 points, gaps closed": closed,
    }.items():
        rates[name] = per_second(lambda one=one: one.transform(masks), len(masks))
        both = ShapeContextHistogram.from_arrays(one.to_arrays()).set_params(n_jobs=2)
        many = masks * 5  # enough work for two
        rates[f"{name}, two cores"] = per_second(
            lambda both=both, many=many: both.transform(many), len(many)
        )
    rates["in NumPy, 200 edge points on pixels"] = in_numpy(
        along_pixels, masks[: 3 if FAST else 40]
    )
    report(
        f"{len(masks)} masks of 256 x 256, {pixels} boundary pixels on average, one core",
        ["what", "masks per second", "µs a mask"],
        [[name, f"{rate:,.0f}", f"{1e6 / rate:,.0f}"] for name, rate in rates.items()],
    )
    report(
        "where the time goes, 200 edge points, each step alone",
        ["step", "masks per second", "µs a mask"],
        [[n, f"{r:,.0f}", f"{1e6 / r:,.0f}"] for n, r in steps(histogram, masks).items()],
    )

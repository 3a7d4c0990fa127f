"""Learn how sure a fit may be: from unseen takes, damaged masks, and what is no person."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from sklearn.base import clone

from silpose.core.pose_space import ANGLES
from silpose.core.types import Array, Mask
from silpose.dataset import Take
from silpose.evaluation import right_poses
from silpose.fitting import Confidence, Fit, Knowledge
from silpose.model.fitter_training import FitterTraining
from silpose.regression import DistinctNeighbours, folds
from silpose.silhouette import DEGRADATIONS, Body, Camera, degrade, foreign_shape, render

Case = Literal["clean", "damaged", "other", "foreign", "half", "two", "turned"]

CASES: dict[Case, float] = {
    "clean": 0.15, "damaged": 0.35, "other": 0.15, "foreign": 0.2, "half": 0.05, "two": 0.05,
    "turned": 0.05,
}  # fmt: skip
"""What masks show, and how often.

A person as in training; with one of `DEGRADATIONS` that lasts; of another shape, before another
camera; a shape that is no person's; the lower or upper half of a person; two people; a person whose
estimate is turned around.
"""
_FOLDS = 8  # parts in which takes are left out
_FRAMES = 6  # consecutive ones that are fitted together
_STRONGEST = 0.7  # degradation
_PERSON = 1.7  # metres


@dataclass(frozen=True, eq=False)
class Shown:
    """Consecutive masks, and the poses behind them.

    Attributes
    ----------
    case : str
    masks : list of ndarray, each (H, W)
    x : ndarray, shape (F, 55), or None
        None where there is no person.
    roots : ndarray, shape (F, 3)
    camera : Camera
        That the fitter is told.
    """

    case: Case
    masks: list[Mask]
    x: Array | None
    roots: Array
    camera: Camera


def show(take: Take, camera: Camera, body: Body, rng: np.random.Generator) -> Shown:
    """Draw some frames of a take, and what becomes of them."""
    start = int(rng.integers(max(1, len(take) - _FRAMES)))
    frames = np.arange(start, min(start + _FRAMES, len(take)))
    names = list(CASES)
    case = names[int(rng.choice(len(names), p=list(CASES.values())))]
    assert take.masks is not None
    masks = [np.asarray(take.masks[int(frame)]) for frame in frames]
    x, roots, own = take.x[frames], take.offset[frames], take.camera_or(camera)
    if case == "damaged":
        kind = list(DEGRADATIONS)[int(rng.integers(len(DEGRADATIONS)))]
        strength, seed = rng.uniform(0, _STRONGEST), int(rng.integers(2**31))
        masks = [degrade(mask, kind, strength, np.random.default_rng(seed)) for mask in masks]
    elif case == "other":
        masks = _of_another(x, roots, own, body, rng)
    elif case == "foreign":
        tall = own.focal_pixels * _PERSON / own.distance
        mask = foreign_shape(own.height, own.width, tall, rng)
        masks = [mask for _ in masks]
    elif case == "half":
        masks = [_half(mask, upper=bool(frames[0] % 2)) for mask in masks]
    elif case == "two":
        apart = int(rng.choice([-1, 1]) * rng.uniform(0.1, 0.3) * own.height)
        masks = [mask | _moved(mask, apart) for mask in masks]
    return Shown(case, masks, None if case == "foreign" else x, roots, own)


def confidence_examples(
    training: FitterTraining, count: int, rng: np.random.Generator
) -> tuple[Array, Array, list[Case]]:
    """Fit what is drawn from takes that are left out: from their own contours, known and not.

    Parameters
    ----------
    training : FitterTraining
    count : int
        Of pieces of takes.
    rng : numpy.random.Generator

    Returns
    -------
    evidence : ndarray, shape (n, 9)
        Of fitted frames, see `EVIDENCE`.
    right : ndarray of bool, shape (n,)
        Whether their poses are right.
    cases : list of str, n of them
    """
    described, fits = training.described, []
    parts = folds(described.train, most=_FOLDS, groups=described.groups)
    places = {id(take): k for k, take in enumerate(described.train)}
    assert described.descriptor is not None
    for k, part in enumerate(parts):
        others = DistinctNeighbours(part.z, part.x, ANGLES.distance)
        regressor = clone(training.regressor).fit(part.z, part.x)
        takes = [described.data.train[places[id(own)]] for own in part.validation]
        for _ in range(k, count, len(parts)):
            take = takes[int(rng.integers(len(takes)))]
            shown = show(take, training.camera, training.body, rng)
            z = described.descriptor.transform(shown.masks)
            mean, further = regressor.predict(z), others.find(z, training.options.starts)
            if shown.case == "turned":
                mean, further = turned_around(mean), turned_around(further)
            knowledge: Knowledge = "known" if rng.random() < 0.5 else "estimated"
            fitter = training.fitter(
                camera=shown.camera, camera_is=knowledge, shape_is=knowledge,
                whole_take=bool(rng.random() < 0.5), confidence=Confidence(),
            )  # fmt: skip
            roots = shown.roots if knowledge == "known" else None
            fits.append((shown, fitter.fit(shown.masks, mean, others=further, roots=roots)))
    evidence = np.concatenate([fit.evidence for _, fit in fits])
    right = np.concatenate([right_frames(*own) for own in fits])
    cases: list[Case] = [shown.case for shown, fit in fits for _ in fit.iou]
    known = np.isfinite(evidence).all(axis=1)
    return evidence[known], right[known], [c for c, own in zip(cases, known, strict=True) if own]


def right_frames(shown: Shown, fit: Fit) -> NDArray[np.bool_]:
    """Whether each frame's pose is right (F,)."""
    if shown.x is None:
        return np.zeros(len(fit.x), bool)
    return right_poses(ANGLES, shown.x, np.nan_to_num(fit.x))


def turned_around(x: Array) -> Array:
    """Poses (…, 55) whose heading is the opposite."""
    return np.concatenate([-x[..., :2], x[..., 2:]], axis=-1)


def _of_another(
    x: Array, roots: Array, camera: Camera, body: Body, rng: np.random.Generator
) -> list[Mask]:
    """Render the poses with another body, before another camera of the same size."""
    mean = np.zeros(10) if body.shape is None else np.array(body.shape)
    shape = mean + rng.normal(0, rng.uniform(0, 2), 10)
    other = Camera(
        focal_length=camera.focal_length,
        elevation=float(np.clip(camera.elevation + rng.normal(0, 6), -80, 80)),
        distance=float(camera.distance * np.exp(rng.normal(0, 0.15))),
        width=camera.width,
        height=camera.height,
    )
    another = Body(body.kind, body.level, shape=shape.tolist())
    return list(render(another, other, ANGLES.rotations(x), roots))


def _half(mask: Mask, upper: bool) -> Mask:
    half, rows = mask.copy(), np.flatnonzero(mask.any(axis=1))
    middle = int(rows.mean()) if len(rows) else 0
    half[slice(middle, None) if upper else slice(None, middle)] = 0
    return half


def _moved(mask: Mask, columns: int) -> Mask:
    moved = np.zeros_like(mask)
    if columns > 0:
        moved[:, columns:] = mask[:, :-columns]
    elif columns < 0:
        moved[:, :columns] = mask[:, -columns:]
    return moved

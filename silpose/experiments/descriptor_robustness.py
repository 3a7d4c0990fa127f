"""Does the descriptor survive local segmentation errors and occlusion? Section II-A of the paper.

The histogram of shape contexts beside what people would use instead, Hu's moments and principal
components of the aligned mask, with the same regressor behind all three: taught by whole or by
damaged silhouettes, tested on damaged ones.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np
from numpy.typing import NDArray
from sklearn.base import clone

from silpose.core.errors import InputError
from silpose.dataset import Dataset
from silpose.descriptor import AlignedMask, HuMoments
from silpose.experiments.descriptor_robustness_figure import TAUGHT, Masks, Rows, robustness_figure
from silpose.experiments.setup import Components, masks_of, studio_of
from silpose.model.describe import Descriptor, examples
from silpose.model.training import DescribedDataset, compare
from silpose.recording import record_study
from silpose.recording.runs.run_folder import Run
from silpose.regression import Candidates, Regressor
from silpose.silhouette import Degradation, contour_damage, degrade

Array = NDArray[np.float64]

OURS, REGRESSION = "shape_contexts", "ridge"


@dataclass(frozen=True)
class Pipeline:
    """A descriptor and the regressor behind it."""

    descriptor: Descriptor
    regressor: Regressor

    def estimate(self, masks: Sequence[NDArray[np.uint8]]) -> Array:
        """Pose of each mask, shape (n, D)."""
        return self.regressor.predict(self.descriptor.transform(masks))


def descriptor_robustness(
    rooms: Components,
    run: Run,
    kinds: list[str],
    strengths: list[float],
    taught: float,
    damage: float,
    every: int,
) -> None:
    """Degrade the test silhouettes, each kind at rising strength, and see what is left.

    Parameters
    ----------
    rooms : Components
    run : Run
    kinds : list of str
        Of degradation.
    strengths : list of float
        Of each.
    taught : float
        Where damaged silhouettes teach, four of five suffer one of the kinds at a strength between
        0 and this.
    damage : float
        Share of the contour at which the share of the gain that is lost is told.
    every : int
        One of so many test frames is degraded.
    """
    if not kinds or not strengths or every < 1 or not 0 < damage < 1:
        raise InputError("name kinds and strengths; every is at least 1, damage between 0 and 1")
    studio = studio_of(rooms, run)
    for strength in strengths:
        Degradation(test=kinds, strength=strength)  # which complains before time is spent
    lessons = Degradation([*4 * kinds, *["none"] * len(kinds)], [], [0.0, taught], rooms.seed)
    with run.stage("masks"):
        data = rooms.dataset()
        whole = [mask for take in data.test for mask in masks_of(take, run)][::every]
        true = np.concatenate([take.x for take in data.test])[::every]
    with run.stage("regression"):
        hurt = replace(studio, degradation=lessons).dataset()
        eyes, described = _teach(rooms, data, hurt)
        estimates, _ = compare(described, {})
    metrics = {
        baseline: {"whole_error": float(data.space.distance(true, estimated[::every]).mean())}
        for baseline, estimated in estimates.items()
    }
    nothing = metrics["mean_pose"]["whole_error"]
    errors = {
        name: float(data.space.distance(true, eye.estimate(whole)).mean())
        for name, eye in eyes.items()
    }
    rows: Rows = []
    with run.stage("degradation"):
        for kind, strength in product(kinds, sorted(strengths)):
            damaged = _damage(whole, kind, strength, rooms.seed)
            share = np.mean([contour_damage(*pair) for pair in zip(whole, damaged, strict=True)])
            for name, eye in eyes.items():
                error = float(data.space.distance(true, eye.estimate(damaged)).mean())
                rows.append(
                    {"descriptor": name, "kind": kind, "strength": strength, "damage": float(share)}
                    | {"error": error}
                    | {"gain_lost": (error - errors[name]) / (nothing - errors[name])}
                )
    lost = {name: {kind: _lost_at(damage, rows, name, kind) for kind in kinds} for name in eyes}
    for name, error in errors.items():
        gain_lost = float(np.mean(list(lost[name].values())))
        metrics[name] = {"whole_error": error, "gain_lost": gain_lost}
        metrics[name] |= {f"gain_lost_{kind}": value for kind, value in lost[name].items()}
    unit = data.space.metrics[0].replace("_", " ")
    with run.writing("descriptor_robustness.png") as path:
        robustness_figure(path, rows, errors, nothing, lost, damage, whole, unit, rooms.seed)
    _record(rooms, run, data, eyes, kinds, metrics, unit)
    run.write_settings()
    run.write_results(rows)
    run.write_metrics(data.name, rooms.seed, metrics)


def _teach(
    rooms: Components, whole: Dataset, damaged: Dataset
) -> tuple[dict[str, Pipeline], DescribedDataset]:
    """Fit every descriptor and its regressor to either; describe whole silhouettes by ours."""
    eyes: dict[str, Pipeline] = {}
    ours: list[DescribedDataset] = []
    for lesson, data in (("", whole), (TAUGHT, damaged)):
        for name, descriptor in {
            OURS: clone(rooms.descriptor),
            "aligned_mask_pca": AlignedMask(random_state=rooms.seed),
            "hu_moments": HuMoments(),
        }.items():
            described, regressor = _learn(data, descriptor, rooms.candidates, name == OURS)
            eyes[name + lesson] = Pipeline(descriptor, regressor)
            ours.append(described)
    return eyes, ours[0]


def _learn(
    data: Dataset, descriptor: Descriptor, candidates: Candidates, histogram: bool
) -> tuple[DescribedDataset, Regressor]:
    descriptor.fit([mask for take in data.train if take.masks is not None for mask in take.masks])
    parts = (examples(descriptor, part) for part in (data.train, data.validation, data.test))
    described = DescribedDataset(data, None, *parts)
    basis = replace(candidates.basis, hellinger=candidates.basis.hellinger and histogram)
    chosen = described.learn(replace(candidates, basis=basis), [REGRESSION])
    return described, chosen.regressors[REGRESSION]


def _damage(masks: Masks, kind: str, strength: float, seed: int) -> Masks:
    """Degrade every mask; a frame's damage is at the same place whatever the strength."""
    return [
        degrade(mask, kind, strength, np.random.default_rng([seed, frame]))
        for frame, mask in enumerate(masks)
    ]


def _lost_at(damage: float, rows: Rows, name: str, kind: str) -> float:
    """Share of the gain lost where so much of the contour is damaged, or at the kind's worst."""
    own = [row for row in rows if (row["descriptor"], row["kind"]) == (name, kind)]
    shares = [0.0, *(float(str(row["damage"])) for row in own)]
    return float(np.interp(damage, shares, [0.0, *(float(str(row["gain_lost"])) for row in own)]))


def _record(
    rooms: Components,
    run: Run,
    data: Dataset,
    eyes: Mapping[str, Pipeline],
    kinds: Sequence[str],
    metrics: dict[str, dict[str, float]],
    unit: str,
) -> None:
    """Record the first test sequence, one kind after the other rising from nothing to 1."""
    take = data.test[0]
    length = int(np.ceil(len(take) / len(kinds)))
    frames = np.arange(len(take))
    masks = [
        degrade(
            mask, kinds[int(f) // length], f % length / length, np.random.default_rng(f // length)
        )
        for f, mask in zip(frames, masks_of(take, run), strict=True)
    ]
    series = {
        name: data.space.distance(take.x, eye.estimate(masks))
        for name, eye in eyes.items()
        if not name.endswith(TAUGHT)
    }
    told = ", ".join(f"{kind} from frame {k * length}" for k, kind in enumerate(kinds))
    record_study(
        run.header(f"test sequence {take.name}: {told}", metrics),
        run.folder / "descriptor_robustness.png",
        series,
        f"{unit}, taught by whole silhouettes, each damage rising from nothing",
        take.frames_per_second,
        masks,
    )

"""Does the descriptor survive local segmentation errors and occlusion? Section II-A of the paper.

The histogram of shape contexts beside common alternatives, Hu's moments and principal components
of the aligned mask, with the same regressor behind all three: trained on clean or on degraded
silhouettes, tested on degraded ones.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import product

import numpy as np
from sklearn.base import clone

from silpose.core.errors import InputError
from silpose.core.parameters import POSITIVE_INTEGER, check_values
from silpose.core.stages import stage
from silpose.core.types import Array, Mask, Metrics, Row
from silpose.dataset import Dataset
from silpose.descriptor import AlignedMask, HuMoments
from silpose.experiments.descriptor_robustness_figure import (
    TRAINED_ON_DEGRADED,
    descriptor_robustness_figure,
)
from silpose.experiments.setup import Components, renderer_of
from silpose.model import DescribedDataset, Descriptor, compare, describe_takes
from silpose.recording import Header, Recording, Result, palette, record_study
from silpose.recording.captions import coloured, in_words
from silpose.regression import RegressionCandidates, Regressor
from silpose.silhouette import SEGMENTATION_FAULTS, Degradation, contour_damage, degrade

SHAPE_CONTEXTS, METHOD = "shape_contexts", "ridge"
_DRAWN = dict(zip(("shape contexts", "aligned mask", "Hu moments"), palette.MODES[:3], strict=True))


@dataclass(frozen=True)
class Pipeline:
    """A descriptor and the regressor behind it."""

    descriptor: Descriptor
    regressor: Regressor

    def estimate(self, masks: Sequence[Mask]) -> Array:
        """Pose of each mask, shape (n, D)."""
        return self.regressor.predict(self.descriptor.transform(masks))


def descriptor_robustness(
    components: Components,
    *,
    kinds: Sequence[str] = SEGMENTATION_FAULTS,
    strengths: Sequence[float] = (0.1, 0.2, 0.4, 0.7, 1),
    training_strength: float = 0.6,
    damage: float = 0.2,
    every: int = 3,
) -> Result:
    """Degrade the test silhouettes, each kind at rising strength, and measure what is left.

    Parameters
    ----------
    components : Components
    kinds : sequence of str, default=SEGMENTATION_FAULTS
        Kinds of degradation.
    strengths : sequence of float, default=(0.1, 0.2, 0.4, 0.7, 1)
        Strengths of each.
    training_strength : float, default=0.6
        The greatest strength of degradation in training, where four of five silhouettes suffer one
        of the kinds.
    damage : float, default=0.2
        Share of the contour, lost or false, at which descriptors are compared.
    every : int, default=3
        One of so many test frames is degraded.
    """
    check_values("every", POSITIVE_INTEGER, every)
    if not kinds or not strengths or not 0 < damage < 1:
        raise InputError("give kinds, strengths, and a damage between 0 and 1")
    renderer = renderer_of(components, "descriptor_robustness")
    for strength in strengths:
        Degradation(test=list(kinds), strength=strength)  # refuses before time is spent
    training = [*4 * list(kinds), *["none"] * len(kinds)]
    degradation = Degradation(
        train=training, strength=[0.0, training_strength], seed=components.seed
    )
    data = components.load()
    degraded = components.dataset.load(replace(renderer, degradation=degradation))
    clean = [mask for take in data.test for mask in take.mask_array()][::every]
    true = np.concatenate([take.x for take in data.test])[::every]
    pipelines, described = _train(components, data, degraded)
    distance = data.space.distance
    metrics: Metrics = {
        baseline: {"whole_error": float(distance(true, estimated[::every]).mean())}
        for baseline, estimated in compare(described, {})[0].items()
    }
    mean_pose_error = metrics["mean_pose"]["whole_error"]
    errors = {
        name: float(distance(true, pipeline.estimate(clean)).mean())
        for name, pipeline in pipelines.items()
    }
    rows: list[Row] = []
    with stage("degradation"):
        for kind, strength in product(kinds, sorted(strengths)):
            masks = _degrade(clean, kind, strength, components.seed)
            share = np.mean([contour_damage(*pair) for pair in zip(clean, masks, strict=True)])
            for name, pipeline in pipelines.items():
                error = float(distance(true, pipeline.estimate(masks)).mean())
                gain_lost = (error - errors[name]) / (mean_pose_error - errors[name])
                rows.append(
                    {"descriptor": name, "kind": kind, "strength": strength}
                    | {"damage": float(share), "error": error, "gain_lost": gain_lost}
                )
    lost = {n: {kind: _lost_at(damage, rows, n, kind) for kind in kinds} for n in pipelines}
    for name, error in errors.items():
        mean_lost = float(np.mean(list(lost[name].values())))
        metrics[name] = {"whole_error": error, "gain_lost": mean_lost}
        metrics[name] |= {f"gain_lost_{kind}": value for kind, value in lost[name].items()}
    unit = in_words(data.space.metrics[0])
    figure = descriptor_robustness_figure(
        rows, errors, mean_pose_error, lost, damage, clean[len(clean) // 3], unit, components.seed
    )
    length = _frames_per_kind(data, kinds)
    order = ", ".join(f"{kind} from frame {k * length}" for k, kind in enumerate(kinds))
    return Result(
        data.name,
        metrics,
        rows=rows,
        figure=figure,
        recording=Recording(
            f"Shown: {data.test[0].title}; each kind rises from nothing: {order.replace('_', ' ')}",
            partial(_record, data, pipelines, kinds, unit),
        ),
    )


def _train(
    components: Components, clean: Dataset, degraded: Dataset
) -> tuple[dict[str, Pipeline], DescribedDataset]:
    """Fit every descriptor and its regressor to both; describe the clean one by shape contexts."""
    pipelines: dict[str, Pipeline] = {}
    first: list[DescribedDataset] = []
    for suffix, data in (("", clean), (TRAINED_ON_DEGRADED, degraded)):
        for name, descriptor in {
            SHAPE_CONTEXTS: clone(components.descriptor),
            "aligned_mask_pca": AlignedMask(random_state=components.seed),
            "hu_moments": HuMoments(),
        }.items():
            histogram = name == SHAPE_CONTEXTS
            described, regressor = _fit(data, descriptor, components.regression, histogram)
            pipelines[name + suffix] = Pipeline(descriptor, regressor)
            first.append(described)
    return pipelines, first[0]


def _fit(
    data: Dataset, descriptor: Descriptor, candidates: RegressionCandidates, histogram: bool
) -> tuple[DescribedDataset, Regressor]:
    with stage("descriptors"):
        descriptor.fit([mask for take in data.train for mask in take.mask_array()])
        splits = (data.train, data.validation, data.test)
        parts = [describe_takes(descriptor, split) for split in splits]
    described = DescribedDataset(data, None, *parts)
    roots = candidates.basis.estimator.hellinger and histogram
    basis = candidates.basis.with_parameters(hellinger=roots)
    chosen = described.choose(replace(candidates, basis=basis), [METHOD])
    return described, chosen.regressors[METHOD]


def _degrade(masks: Sequence[Mask], kind: str, strength: float, seed: int) -> list[Mask]:
    """Degrade every mask; a frame's damage is at the same place whatever the strength."""
    return [
        degrade(mask, kind, strength, np.random.default_rng([seed, frame]))
        for frame, mask in enumerate(masks)
    ]


def _lost_at(damage: float, rows: Sequence[Row], name: str, kind: str) -> float:
    """Share of the gain lost where so much of the contour is damaged, or at the kind's worst."""
    own = [row for row in rows if (row["descriptor"], row["kind"]) == (name, kind)]
    shares, lost = ([0.0, *(row[key] for row in own)] for key in ("damage", "gain_lost"))
    return float(np.interp(damage, shares, lost))


def _frames_per_kind(data: Dataset, kinds: Sequence[str]) -> int:
    return -(-len(data.test[0]) // len(kinds))


def _record(
    data: Dataset,
    pipelines: Mapping[str, Pipeline],
    kinds: Sequence[str],
    unit: str,
    header: Header,
) -> None:
    """Record the first test take, one kind after the other rising from nothing to 1."""
    take, length = data.test[0], _frames_per_kind(data, kinds)
    masks = []
    for frame, mask in enumerate(take.mask_array()):
        kind, strength = kinds[frame // length], frame % length / length
        masks.append(degrade(mask, kind, strength, np.random.default_rng(frame // length)))
    record_study(
        header,
        series={
            name: data.space.distance(take.x, pipeline.estimate(masks))
            for name, pipeline in pipelines.items()
            if not name.endswith(TRAINED_ON_DEGRADED)
        },
        title=unit,
        legend=coloured(_DRAWN),
        frames_per_second=take.frames_per_second,
        masks=masks,
    )

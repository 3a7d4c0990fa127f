"""What most experiments begin with: data, descriptors, regressors chosen by validation."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from silpose.dataset import Dataset, poses
from silpose.descriptor import ShapeContextHistogram
from silpose.evaluation import baselines, measure
from silpose.experiments.setup import Components
from silpose.model.describe import describe, learn_descriptor
from silpose.model.pose_model import PoseModel
from silpose.recording.runs.run_folder import Run
from silpose.regression import (
    Candidates,
    Chosen,
    MixtureOfRegressors,
    MixtureSettings,
    Regressor,
    RidgeRegressor,
    choose_mixture,
)

Array = NDArray[np.float64]
Examples = list[tuple[Array, Array]]
Error = Callable[[Array, Array], float]


@dataclass(frozen=True)
class DescribedDataset:
    """A dataset whose masks are described.

    Attributes
    ----------
    data : Dataset
    descriptor : ShapeContextHistogram or None
    train, validation, test : list of (z, x)
        Of each sequence.
    """

    data: Dataset
    descriptor: ShapeContextHistogram | None
    train: Examples
    validation: Examples
    test: Examples

    def learn(
        self,
        candidates: Candidates,
        methods: Sequence[str],
        part: str | None = None,
    ) -> Chosen:
        """Fit methods with the settings best on validation, to the whole pose or to one part."""
        train, validation = self.examples("train", part), self.examples("validation", part)
        space = self.data.space
        units = space.units if part is None else space.units[space.parts[part]]
        return candidates.choose(methods, train, validation, self.error(part), units, self.groups)

    def learn_ridge(self, candidates: Candidates) -> RidgeRegressor:
        """Fit kernel ridge regression with the settings best on validation."""
        ridge = self.learn(candidates, ["ridge"]).regressors["ridge"]
        assert isinstance(ridge, RidgeRegressor)
        return ridge

    def learn_mixture(
        self, settings: MixtureSettings, shared: Regressor
    ) -> tuple[MixtureOfRegressors, list[dict[str, object]]]:
        """Fit the mixture of regressors likeliest on validation; give the account of it, too.

        Parameters
        ----------
        settings : MixtureSettings
        shared : Regressor
            With the settings best on validation.
        """
        space = self.data.space
        return choose_mixture(
            self.train, self.validation, settings, space.units, space.distance, self.groups, shared
        )

    @property
    def groups(self) -> list[str] | None:
        """Performers of the training sequences, where these are what may not be mixed."""
        return [take.performer for take in self.data.train] if self.data.by_performer else None

    def examples(self, split: str, part: str | None = None) -> Examples:
        """Give z and x of each sequence of a split, x whole or one part's columns."""
        examples: Examples = getattr(self, split)
        if part is None:
            return examples
        columns = self.data.space.parts[part]
        return [(z, x[:, columns]) for z, x in examples]

    def error(self, part: str | None = None) -> Error:
        """Give the function that measures true against estimated poses, whole or of a part."""
        return lambda true, estimated: float(self.distances(part, true, estimated).mean())

    def distances(self, part: str | None, true: Array, estimated: Array) -> Array:
        """Distance of whole poses, or of a part's columns, frame by frame."""
        space = self.data.space
        if part is None:
            return space.distance(true, estimated)
        return space.part_distance(part, true, estimated)

    def mean_pose(self, part: str | None = None) -> Array:
        """Mean training pose, whole or of a part, shape (D,)."""
        return np.concatenate([x for _, x in self.examples("train", part)]).mean(axis=0)

    def model(self, regressor: Regressor) -> PoseModel:
        """Put what was learnt together."""
        return PoseModel(
            self.descriptor, regressor, self.data.space, self.data.test[0].frames_per_second
        )


def prepare(rooms: Components, run: Run) -> DescribedDataset:
    """Photograph or read the dataset, learn the codebook, describe every mask."""
    with run.stage("masks"):
        data = rooms.dataset()
    with run.stage("descriptors"):
        return described(rooms, data)


def described(rooms: Components, data: Dataset) -> DescribedDataset:
    """Learn the codebook and describe every mask, or take both from the shelf."""
    splits = [data.train, data.validation, data.test]
    lengths = [len(take) for split in splits for take in split]
    kept = rooms.shelf.fetch(lengths) if rooms.shelf else None
    descriptor = kept[0] if kept else learn_descriptor(rooms.descriptor, data.train)
    z = kept[1] if kept else [own for split in splits for own in describe(descriptor, split)]
    if rooms.shelf and descriptor is not None and not kept:
        rooms.shelf.store(descriptor, z)
    rest = iter(z)
    parts = ([(next(rest), take.x) for take in split] for split in splits)
    return DescribedDataset(data, descriptor, *parts)


def compare(
    described: DescribedDataset, regressors: dict[str, Regressor]
) -> tuple[dict[str, Array], dict[str, dict[str, float]]]:
    """Estimate the test poses by the baselines and by regressors, and measure all of them."""
    space = described.data.space
    z_train, x_train = (np.concatenate(part) for part in zip(*described.train, strict=True))
    z_test = np.concatenate([z for z, _ in described.test])
    x_test = poses(described.data.test)
    estimates = baselines(space, z_train, x_train, z_test, x_test)
    estimates |= {m: regressor.predict(z_test) for m, regressor in regressors.items()}
    metrics = {m: measure(space, x_test, e, x_train) for m, e in estimates.items()}
    for method, regressor in regressors.items():
        metrics[method] |= {"kept": regressor.kept_, "kept_per_output": regressor.kept_per_output_}
    return estimates, metrics


def tidy(metrics: dict[str, dict[str, float]]) -> list[dict[str, object]]:
    """Rows of ``results.csv``: one per method and value."""
    return [
        {"method": method, "metric": name, "value": value}
        for method, values in metrics.items()
        for name, value in values.items()
    ]

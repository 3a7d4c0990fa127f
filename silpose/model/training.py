"""A described dataset, and the single-image models fitted to it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.known_results import KnownResults
from silpose.core.serialisation import State
from silpose.core.stages import timed
from silpose.core.types import Array, Examples, Metrics
from silpose.dataset import Dataset, Take
from silpose.descriptor import ShapeContextHistogram
from silpose.evaluation import baselines, measure
from silpose.model.confidence import Confidence, train_confidence
from silpose.model.describe import describe, fit_descriptor
from silpose.model.pose_fitter import PoseFitter
from silpose.model.pose_model import PoseModel
from silpose.regression import (
    Candidates,
    ChosenMixture,
    ChosenRegressors,
    MixtureOfRegressors,
    RegressionCandidates,
    Regressor,
    RidgeRegressor,
    choose_mixture,
    choose_regressors,
)
from silpose.tracking import Tracker

Error = Callable[[Array, Array], float]
"""From true and estimated poses (F, D) to one number."""


@dataclass(frozen=True)
class DescribedDataset:
    """A dataset and its descriptors.

    Attributes
    ----------
    data : Dataset
    descriptor : ShapeContextHistogram or None
        None where the dataset holds descriptors of unknown origin.
    train, validation, test : sequence of (z, x)
        Descriptors (F, d) and poses (F, D) of each take.
    known : KnownResults
        Scores of settings from runs before.
    """

    data: Dataset
    descriptor: ShapeContextHistogram | None
    train: Examples
    validation: Examples
    test: Examples
    known: KnownResults = field(default_factory=KnownResults, kw_only=True)

    @timed("regression")
    def choose(
        self, candidates: RegressionCandidates, methods: Sequence[str], part: str | None = None
    ) -> ChosenRegressors:
        """Fit regression methods with the settings best on validation.

        Parameters
        ----------
        candidates : RegressionCandidates
        methods : sequence of str
        part : str, optional
            A body part, whose columns alone are regressed; the whole pose if not given.
        """
        space = self.data.space
        units: ArrayLike = space.units if part is None else space.units[space.parts[part]]
        train, validation = self.examples("train", part), self.examples("validation", part)
        return choose_regressors(
            candidates,
            methods,
            train,
            validation,
            self.error(part),
            units=units,
            groups=self.groups,
            known=self.known.depending_on(train, validation, self.groups, space, part),
        )

    def choose_ridge(self, candidates: RegressionCandidates) -> RidgeRegressor:
        """Fit kernel ridge regression with the settings best on validation."""
        ridge = self.choose(candidates, ["ridge"]).regressors["ridge"]
        assert isinstance(ridge, RidgeRegressor)
        return ridge

    @timed("regression")
    def choose_mixture(
        self, candidates: Candidates[MixtureOfRegressors], shared: Regressor
    ) -> ChosenMixture:
        """Fit the mixture of regressors that is likeliest on validation.

        Parameters
        ----------
        candidates : Candidates of MixtureOfRegressors
        shared : Regressor
            Single-image regressor, with the settings best on validation.
        """
        space = self.data.space
        return choose_mixture(
            candidates,
            self.train,
            self.validation,
            units=space.units,
            distance=space.distance,
            groups=self.groups,
            shared=shared,
            known=self.known.depending_on(self.train, self.validation, self.groups, space),
        )

    @property
    def groups(self) -> list[str] | None:
        """Performers of the training takes, where folds may not mix these."""
        return [take.performer for take in self.data.train] if self.data.by_performer else None

    @property
    def frames_per_second(self) -> float:
        """Rate of the test takes."""
        return self.data.test[0].frames_per_second

    def examples(self, split: str, part: str | None = None) -> Examples:
        """Descriptors and poses of each take.

        Parameters
        ----------
        split : {"train", "validation", "test"}
        part : str, optional
            A body part, of whose columns the poses consist.
        """
        examples: Examples = getattr(self, split)
        if part is None:
            return examples
        columns = self.data.space.parts[part]
        return [(z, x[:, columns]) for z, x in examples]

    def joined(self, split: str) -> tuple[Array, Array]:
        """Descriptors (n, d) and poses (n, D) of all takes of a split, one after the other."""
        z, x = zip(*self.examples(split), strict=True)
        return np.concatenate(z), np.concatenate(x)

    def error(self, part: str | None = None) -> Error:
        """Mean distance of true and estimated poses, as a function; whole or of a body part."""
        return lambda true, estimated: float(self.distances(part, true, estimated).mean())

    def distances(self, part: str | None, true: Array, estimated: Array) -> Array:
        """Distance of whole poses (F, D), or of a body part's columns, shape (F,)."""
        space = self.data.space
        if part is None:
            return space.distance(true, estimated)
        return space.part_distance(part, true, estimated)

    def mean_pose(self, part: str | None = None) -> Array:
        """Mean training pose, whole or of a body part, shape (D,)."""
        return np.concatenate([x for _, x in self.examples("train", part)]).mean(axis=0)

    def model(
        self,
        regressor: Regressor,
        tracker: Tracker | None = None,
        fitter: PoseFitter | None = None,
    ) -> PoseModel:
        """Combine the descriptor with what was fitted to its output; calibrate its confidence."""
        space, rate = self.data.space, self.frames_per_second
        confidence = self._confidence(regressor)
        return PoseModel(self.descriptor, regressor, space, rate, tracker, fitter, confidence)

    @timed("confidence")
    def _confidence(self, regressor: Regressor) -> Confidence:
        return train_confidence(self, regressor)


@timed("descriptors")
def describe_dataset(
    data: Dataset, descriptor: ShapeContextHistogram, known: KnownResults | None = None
) -> DescribedDataset:
    """Fit the codebook and describe every mask.

    Parameters
    ----------
    data : Dataset
    descriptor : ShapeContextHistogram
        Never changed: a copy is fitted to the training masks.
    known : KnownResults, optional
        Holds both from one run to the next, and scores of settings, too.
    """
    known = known or KnownResults()
    splits = [data.train, data.validation, data.test]
    lengths = [len(take) for split in splits for take in split]
    if known.folder is None or not any(take.has_masks for take in data.train):
        fitted, z = _described(splits, descriptor)
    else:
        compute = partial(_described_state, splits, descriptor)
        seen = [[(take.x, take.offset, take.camera) for take in split] for split in splits]
        state = known.recall_arrays(compute, "descriptors", descriptor, seen)
        fitted = type(descriptor).from_arrays(state)
        z = np.split(state["z"], np.cumsum(lengths)[:-1])
    rest = iter(z)
    parts = ([(next(rest), take.x) for take in split] for split in splits)
    return DescribedDataset(data, fitted, *parts, known=known)


def _described(
    splits: Sequence[Sequence[Take]], descriptor: ShapeContextHistogram
) -> tuple[ShapeContextHistogram | None, list[Array]]:
    """Fit a descriptor to the first split, and describe the takes of all."""
    fitted = fit_descriptor(descriptor, splits[0])
    return fitted, [own for split in splits for own in describe(fitted, split)]


def _described_state(splits: Sequence[Sequence[Take]], descriptor: ShapeContextHistogram) -> State:
    """Return the same as arrays."""
    fitted, z = _described(splits, descriptor)
    assert fitted is not None  # there are masks
    return {"z": np.concatenate(z), **fitted.to_arrays()}


@timed("evaluation")
def compare(
    described: DescribedDataset, regressors: dict[str, Regressor]
) -> tuple[dict[str, Array], Metrics]:
    """Estimate the test poses by the baselines and by regressors, and measure all of them.

    Parameters
    ----------
    described : DescribedDataset
    regressors : dict of Regressor
        Fitted, by method.

    Returns
    -------
    estimates : dict of ndarray, shape (n, D)
        By method, of all test takes one after the other.
    metrics : dict
        By method, then by name.
    """
    space = described.data.space
    z_train, x_train = described.joined("train")
    z, x = described.joined("test")
    estimates = baselines(space, z_train, x_train, z, x)
    estimates |= {m: regressor.predict(z) for m, regressor in regressors.items()}
    metrics = {m: measure(space, x, e, x_train) for m, e in estimates.items()}
    for method, regressor in regressors.items():
        metrics[method] |= {"kept": regressor.kept_, "kept_per_output": regressor.kept_per_output_}
    return estimates, metrics

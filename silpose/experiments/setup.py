"""What experiments begin with: components, and the data that are prepared from them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from silpose.core.errors import InputError
from silpose.core.known_results import KnownResults
from silpose.core.types import Metrics, Row
from silpose.dataset import Dataset, DatasetSource, Renderer, Take
from silpose.descriptor import ShapeContextHistogram
from silpose.fitting import FittingOptions
from silpose.model import (
    DescribedDataset,
    FitterTraining,
    PoseFitter,
    TrackerTraining,
    describe_dataset,
)
from silpose.recording import RunFolder
from silpose.regression import RegressionCandidates, Regressor
from silpose.silhouette import Camera
from silpose.silhouette.masks import MaskSource
from silpose.silhouette.video import VideoMasks
from silpose.tracking import Tracker, TrackingCandidates

MODES_SHOWN = 4
"""Modes of p(x|z) in a recording."""


@dataclass(frozen=True)
class Components:
    """What an experiment is made of.

    Attributes
    ----------
    dataset : DatasetSource
        Splits the renderer's takes, or reads a file.
    renderer : Renderer
        Renders masks of motion; not used by a dataset that is read from a file.
    camera : Camera
        Camera of takes that have none of their own.
    masks : MaskSource
        The user's own masks.
    descriptor : ShapeContextHistogram
        Not fitted.
    regression : RegressionCandidates
        Regressors and mixtures, and the settings to choose from.
    tracking : TrackingCandidates
        Trackers and their baselines, and the settings to choose from.
    fitting : FittingOptions
        Whether and how bodies are fitted to masks.
    seed : int
    known : callable
        Gives the descriptors, and scores of settings, that runs before have left.
    video : callable
        Makes a `VideoMasks` of its settings, given source, person and frames_per_second.
    trained_by : callable
        Gives a name to all settings that a model's training depends on.
    run : RunFolder or None
        Folder of the run, for what is recorded while it goes on.
    """

    dataset: DatasetSource
    renderer: Renderer
    camera: Camera
    masks: MaskSource
    descriptor: ShapeContextHistogram
    regression: RegressionCandidates
    tracking: TrackingCandidates
    fitting: FittingOptions = field(default_factory=FittingOptions)
    seed: int = 0
    known: Callable[[], KnownResults] = KnownResults
    video: Callable[..., VideoMasks] = VideoMasks
    trained_by: Callable[[], str] = str
    run: RunFolder | None = None

    def load(self) -> Dataset:
        """Render or read the dataset."""
        return self.dataset.load(self.renderer)


def prepare(components: Components) -> DescribedDataset:
    """Render or read the dataset, fit the codebook and describe every mask."""
    data = components.load()
    if components.fitting.enabled:
        want_masks([*data.train, *data.validation, *data.test], "fitting.enabled=true")
    return describe_dataset(data, components.descriptor, components.known())


def prepare_tracking(components: Components) -> TrackerTraining:
    """Prepare the dataset, and what trackers are fitted with.

    Raises
    ------
    InputError
        If a test take is too short to be tracked.
    """
    described = prepare(components)
    return TrackerTraining.of(described, components.regression, components.tracking)


def prepare_fitting(
    components: Components,
    described: DescribedDataset,
    regressor: Regressor,
    tracker: Tracker | None = None,
) -> FitterTraining:
    """Prepare what a fitter is trained with.

    Parameters
    ----------
    components : Components
    described : DescribedDataset
    regressor : Regressor
        Fitted; its estimates are what fits start from.
    tracker : Tracker, optional
        Fitted; then whole takes start from its estimates.
    """
    renderer = renderer_of(components, "fitting")
    return FitterTraining.of(
        described,
        regressor,
        components.fitting,
        renderer.body,
        components.camera,
        tracker,
        round(components.tracking.lag * described.frames_per_second),
    )


def fitter_of_model(
    components: Components,
    described: DescribedDataset,
    regressor: Regressor,
    tracker: Tracker | None = None,
) -> PoseFitter | None:
    """Train the fitter that a model keeps; none unless fitting is enabled."""
    if not components.fitting.enabled:
        return None
    return prepare_fitting(components, described, regressor, tracker).pose_fitter


def want_masks(takes: Sequence[Take], experiment: str) -> None:
    """Refuse data without masks before time is spent on them."""
    if not all(take.has_masks for take in takes):
        raise InputError(
            f"{experiment} needs masks, and these data hold descriptors only: choose a dataset "
            "that is rendered, such as dataset=same_performer"
        )


def renderer_of(components: Components, experiment: str) -> Renderer:
    """Return the renderer, for an experiment that varies how motion is rendered."""
    if not components.dataset.rendered:
        raise InputError(
            f"{experiment} renders motion and cannot vary what a file holds: choose a dataset "
            "that is rendered, such as dataset=same_performer"
        )
    return components.renderer


def tidy(metrics: Metrics) -> list[Row]:
    """Rows of ``results.csv``: one per method and value."""
    return [
        {"method": method, "metric": name, "value": value}
        for method, values in metrics.items()
        for name, value in values.items()
    ]

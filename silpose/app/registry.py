"""Which class or function each group of settings describes: one table, read without importing it.

A new variant of something takes one line here and a file in ``conf/``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pkgutil import resolve_name
from typing import Any

from silpose.app.signatures import Parameter, descriptions, parameters

_TRACKER = ("space", "frames_per_second")  # as the dataset has them


@dataclass(frozen=True)
class Component:
    """A class or function that is called with settings.

    Attributes
    ----------
    path : str
        ``"package:name"``.
    given : tuple of str, default=()
        Parameters that the program gives, so that they are no settings.
    candidates : bool, default=False
        Whether a list may stand for a single value: values that validation chooses from.
    """

    path: str
    given: tuple[str, ...] = ()
    candidates: bool = False

    @property
    def settings(self) -> Mapping[str, Parameter]:
        """Parameters that are settings, by name."""
        found = parameters(self.path)
        return {name: found[name] for name in found if name not in self.given}

    @property
    def descriptions(self) -> Mapping[str, str]:
        """What the docstring says of each parameter."""
        return descriptions(self.path)

    def load(self) -> Callable[..., Any]:
        """Import the class or function."""
        loaded: Callable[..., Any] = resolve_name(self.path)
        return loaded


def _candidates(path: str, *given: str) -> Component:
    return Component(path, given, candidates=True)


ALTERNATIVES: dict[str, dict[str, Component]] = {
    "motion": {
        "walker": Component("silpose.motion:WalkerTakes"),
        "folder": Component("silpose.motion:MotionFolder"),
    },
    "dataset": {
        "same_performer": Component("silpose.dataset:SamePerformer"),
        "cross_performer": Component("silpose.dataset:CrossPerformer"),
        "cross_camera": Component("silpose.dataset:CrossCamera"),
        "agarwal": Component("silpose.dataset:AgarwalFile"),
    },
    "descriptor": {"shape_context": Component("silpose.descriptor:ShapeContextHistogram")},
}
"""Groups whose ``kind`` names one of several components."""

COMPONENTS: dict[str, Component] = {
    "": Component("silpose.app.run:RunOptions"),
    "silhouette": Component("silpose.silhouette.masks:MaskSource"),
    "silhouette.body": Component("silpose.silhouette:Body"),
    "silhouette.camera": Component("silpose.silhouette:Camera"),
    "silhouette.scenes": Component("silpose.dataset:SceneSampler"),
    "silhouette.degradation": Component("silpose.silhouette:Degradation"),
    "silhouette.video": Component(
        "silpose.silhouette.video:VideoMasks", ("source", "person", "frames_per_second")
    ),
    "regression": Component("silpose.regression:RegressionCandidates"),
    "regression.basis": _candidates("silpose.regression:Basis"),
    "regression.ridge": _candidates("silpose.regression:RidgeRegressor"),
    "regression.rvm": _candidates("silpose.regression:RelevanceVectorRegressor"),
    "regression.svm": _candidates("silpose.regression:SupportVectorRegressor"),
    "regression.mixture": _candidates("silpose.regression:MixtureOfRegressors"),
    "tracking": Component("silpose.tracking:TrackingCandidates"),
    "tracking.tracker": _candidates("silpose.tracking:BeliefTracker", *_TRACKER),
    "tracking.dynamics": _candidates("silpose.tracking:SecondOrderDynamics"),
    "tracking.state_sensitive": _candidates("silpose.tracking:StateSensitiveRegressor"),
    "tracking.single_pose": _candidates("silpose.tracking:SinglePoseTracker", *_TRACKER),
    "tracking.hypotheses": _candidates("silpose.tracking:MultipleHypothesisTracker", *_TRACKER),
    "tracking.baselines": Component("silpose.tracking:SmoothingBaselines"),
    "fitting": Component("silpose.fitting:FittingOptions"),
    "dataset": Component("silpose.app.compose:known_results"),
    "recording": Component(
        "silpose.recording:RunFolder.start", ("experiment", "settings", "defaults", "rows")
    ),
}
"""The component of a group, beside its alternatives if it has any.

The empty name is that of the settings without a group.
"""


def experiment(name: str) -> Component:
    """Name the function of an experiment."""
    return Component(f"silpose.experiments.{name}:{name}")

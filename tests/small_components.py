"""Small components of experiments, made without any configuration."""

from dataclasses import replace

from silpose.dataset import Renderer
from silpose.dataset.take import DatasetSource
from silpose.descriptor import ShapeContextHistogram
from silpose.experiments.setup import Components
from silpose.regression import (
    Basis,
    Candidates,
    MixtureOfRegressors,
    RegressionCandidates,
    RidgeRegressor,
)
from silpose.silhouette import Camera
from silpose.silhouette.masks import MaskSource
from silpose.tracking import (
    BeliefTracker,
    MultipleHypothesisTracker,
    SecondOrderDynamics,
    SinglePoseTracker,
    SmoothingBaselines,
    StateSensitiveRegressor,
    TrackingCandidates,
)

SMALL = Camera(width=96, height=96)

LINEAR = Candidates(Basis(None, linear=True))

REGRESSION = RegressionCandidates(
    basis=Candidates(Basis(width=2)),
    ridge=Candidates(RidgeRegressor(damping=0.1)),
    mixture=Candidates(
        MixtureOfRegressors(temperature=8, noise_width=2),
        {"clusters": [10, 20], "calibration_exponent": [1, 2]},
    ),
)

TRACKING = TrackingCandidates(
    tracker=Candidates(BeliefTracker(pose_width=0.7, descriptor_width=0.6, damping=4)),
    dynamics=Candidates(SecondOrderDynamics(damping=100)),
    state_sensitive=Candidates(
        StateSensitiveRegressor(pose_width=0.5, descriptor_width=2, centres=150)
    ),
    single_pose=Candidates(SinglePoseTracker()),
    hypotheses=Candidates(MultipleHypothesisTracker(velocity_gain=0.7, likelihood_exponent=0.05)),
    baselines=SmoothingBaselines((9,), (3,), (20,), (3,), (0.4,)),
)


class RenderedOnce(DatasetSource):
    """Loads a dataset once for each renderer."""

    def __init__(self, source):
        self.source, self.name, self.rendered = source, source.name, source.rendered
        self._loaded = []

    def load(self, renderer):
        for known, dataset in self._loaded:
            if known is renderer:
                return dataset
        self._loaded.append((renderer, self.source.load(renderer)))
        return self._loaded[-1][1]


def components_of(dataset, source, codebook_size=40, camera=SMALL, **others):
    """Components of a dataset, in small images."""
    return Components(
        RenderedOnce(dataset),
        Renderer(source, camera=camera),
        camera,
        MaskSource(),
        ShapeContextHistogram(codebook_size=codebook_size),
        REGRESSION,
        TRACKING,
        **others,
    )


def with_regression(components, **candidates):
    """Change some of the components' regression candidates."""
    return replace(components, regression=replace(components.regression, **candidates))


def with_tracking(components, **candidates):
    """Change some of the components' tracking candidates."""
    return replace(components, tracking=replace(components.tracking, **candidates))

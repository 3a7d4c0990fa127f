from pathlib import Path

from silpose.app import build_components, load
from silpose.descriptor import ShapeContextHistogram
from silpose.regression import Basis, MixtureOfRegressors, SupportVectorRegressor
from silpose.tracking import BeliefTracker, SmoothingBaselines


def test_what_no_file_says_is_as_constructed():
    components = build_components(load())
    assert components.descriptor.get_params() == ShapeContextHistogram().get_params()
    for candidates, estimator in (
        (components.regression.basis, Basis()),
        (components.regression.svm, SupportVectorRegressor()),
        (components.regression.mixture, MixtureOfRegressors()),
        (components.tracking.tracker, BeliefTracker()),
    ):
        assert candidates.estimator.get_params() == estimator.get_params()
    assert components.tracking.baselines.fusion == list(SmoothingBaselines().fusion)


def test_components_are_of_the_settings():
    overrides = ["silhouette.camera.width=64", "regression.slack=0.1", "tracking.lag=0.2"]
    components = build_components(load(overrides))
    assert components.camera is components.renderer.camera
    assert components.camera.width == 64
    assert components.regression.slack == 0.1
    assert components.regression.ridge.grid["damping"] == [0.01, 0.03, 0.1, 0.3, 1.0]
    assert components.tracking.lag == 0.2


def test_the_cache_is_named_by_what_descriptors_depend_on(tmp_path):
    def file(*overrides):
        return build_components(load(overrides)).known().given

    assert build_components(load()).known().folder == Path("recordings/.cache")
    assert build_components(load(["recording.root=x"])).known().folder == Path("x/.cache")
    assert build_components(load(["dataset.cache=null"])).known().folder is None
    assert file() == file("dataset.cache=elsewhere")
    assert file() == file("regression.slack=0.1", "n_jobs=1")
    assert len({file(), file("seed=1"), file("motion.seconds=3"), file("descriptor.radius=1")}) == 4

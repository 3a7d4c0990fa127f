from dataclasses import replace

import numpy as np
import pytest
from synthetic import motion

from silpose.core.known_results import KnownResults
from silpose.core.pose_space import ANGLES
from silpose.core.stages import timing
from silpose.dataset import Dataset, render_take
from silpose.descriptor import ShapeContextHistogram
from silpose.evaluation import BASELINES
from silpose.model import compare, describe_dataset
from silpose.regression import Basis, Candidates, RegressionCandidates, RidgeRegressor

REGRESSION = RegressionCandidates(
    basis=Candidates(Basis(width=2)), ridge=Candidates(RidgeRegressor(), {"damping": [0.1, 1]})
)


@pytest.fixture(scope="module")
def data(body, camera):
    takes = [render_take(motion(f"take{k}", 24, seed=k), body, camera) for k in range(5)]
    return Dataset("small", ANGLES, takes[:3], takes[3:4], takes[4:])


@pytest.fixture(scope="module")
def described(data):
    return describe_dataset(data, ShapeContextHistogram(codebook_size=20))


def test_every_frame_of_every_split_is_described(data, described):
    for split in ("train", "validation", "test"):
        examples = described.examples(split)
        for (z, x), take in zip(examples, getattr(data, split), strict=True):
            assert z.shape == (24, 20)
            np.testing.assert_array_equal(x, take.x)
    z, x = described.joined("train")
    assert z.shape == (72, 20) and x.shape == (72, 55)
    assert described.frames_per_second == 15


def test_a_part_has_its_own_columns(described):
    columns = ANGLES.parts["left_leg"]
    (_, x), (_, part) = described.test[0], described.examples("test", "left_leg")[0]
    np.testing.assert_array_equal(part, x[:, columns])
    assert described.mean_pose("left_leg").shape == (len(columns),)
    assert described.error("left_leg")(part, part) == 0
    whole = described.distances(None, x, described.mean_pose())
    np.testing.assert_allclose(whole, ANGLES.distance(x, described.mean_pose()))


def test_regressors_are_chosen_on_validation(described):
    with timing() as seconds:
        chosen = described.choose(REGRESSION, ["ridge"])
    assert list(seconds) == ["regression"]
    ((z, x),) = described.validation
    errors = {}
    for damping in (0.1, 1):
        ridge = RidgeRegressor(Basis(width=2), damping=damping).fit(*described.joined("train"))
        errors[damping] = ANGLES.distance(x, ridge.predict(z)).mean()
    assert chosen.validation_error("ridge") == pytest.approx(min(errors.values()))
    assert chosen.regressors["ridge"].damping == min(errors, key=errors.get)


def test_baselines_are_compared_with_regressors(described):
    estimates, metrics = compare(described, {"ridge": described.choose_ridge(REGRESSION)})
    assert list(estimates) == list(metrics) == [*BASELINES, "ridge"]
    error = ANGLES.distance(described.test[0][1], estimates["ridge"]).mean()
    assert metrics["ridge"]["mean_angular_error_deg"] == pytest.approx(error)
    assert metrics["ridge"]["kept"] == 1
    assert "kept" not in metrics["knn"]


def test_groups_are_performers_where_these_are_kept_apart(data, described):
    assert described.groups is None
    takes = [take for split in (data.train, data.validation, data.test) for take in split]
    apart = [
        type(take)(**{**vars(take), "performer": f"performer{k}"}) for k, take in enumerate(takes)
    ]
    strict = Dataset("strict", ANGLES, apart[:3], apart[3:4], apart[4:], by_performer=True)
    described = describe_dataset(strict, ShapeContextHistogram(codebook_size=20))
    assert described.groups == ["performer0", "performer1", "performer2"]


def test_a_cache_takes_the_place_of_describing(data, described, tmp_path, monkeypatch):
    descriptor, known = ShapeContextHistogram(codebook_size=20), KnownResults(tmp_path)
    describe_dataset(data, descriptor, known)
    monkeypatch.setattr("silpose.model.training.describe", None)  # which is not needed again
    cached = describe_dataset(data, descriptor, known)
    np.testing.assert_array_equal(cached.joined("test")[0], described.joined("test")[0])
    np.testing.assert_array_equal(cached.descriptor.codebook_, described.descriptor.codebook_)


@pytest.mark.parametrize("changed", ["data", "descriptor", "frames", "poses"])
def test_what_descriptors_depend_on_is_described_anew(data, tmp_path, monkeypatch, changed):
    descriptor, known = ShapeContextHistogram(codebook_size=20), KnownResults(tmp_path)
    describe_dataset(data, descriptor, known)
    monkeypatch.setattr("silpose.model.training.describe", None)
    if changed == "data":
        known = known.depending_on("other data")
    elif changed == "descriptor":
        descriptor = ShapeContextHistogram(codebook_size=19)
    elif changed == "poses":  # such as of an AMC whose ASF was edited
        data = replace(data, test=[replace(take, x=take.x + 0.1) for take in data.test])
    else:
        data = replace(data, test=[])
    with pytest.raises(TypeError, match="'NoneType' object is not callable"):
        describe_dataset(data, descriptor, known)


def test_the_model_predicts_from_masks_as_the_regressor_from_descriptors(data, described):
    ridge = described.choose_ridge(REGRESSION)
    model = described.model(ridge)
    estimated = model.predict(data.test[0].mask_array()).x
    np.testing.assert_allclose(estimated, ridge.predict(described.test[0][0]))

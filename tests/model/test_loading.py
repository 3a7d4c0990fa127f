import io
import json

import numpy as np
import pytest
from synthetic import motion

import silpose
from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.dataset import render_take
from silpose.descriptor import ShapeContextHistogram
from silpose.model import PoseModel, load
from silpose.model.model_file import write_model_file
from silpose.regression import MixtureOfRegressors, RelevanceVectorRegressor, RidgeRegressor
from silpose.tracking import BeliefTracker, MultipleHypothesisTracker


@pytest.fixture(scope="module")
def examples(body, camera):
    """A descriptor, and z and x of two takes."""
    takes = [render_take(motion(f"take{k}", 60, seed=k), body, camera) for k in range(2)]
    descriptor = ShapeContextHistogram(codebook_size=30).fit(takes[0].masks)
    return descriptor, [(descriptor.transform(take.masks), take.x) for take in takes]


def model_of(examples, regressor, tracker=None):
    descriptor, takes = examples
    z, x = (np.concatenate(part) for part in zip(*takes, strict=True))
    return PoseModel(descriptor, regressor.fit(z, x), ANGLES, 15.0, tracker)


@pytest.fixture(scope="module")
def model(examples):
    return model_of(examples, RidgeRegressor(damping=0.01))


@pytest.mark.parametrize("regressor", [RidgeRegressor(damping=0.01), RelevanceVectorRegressor()])
def test_saved_and_loaded_it_predicts_the_same(examples, regressor, sequence, tmp_path):
    model = model_of(examples, regressor)
    model.save(tmp_path / "model.npz")
    for place in (tmp_path / "model.npz", str(tmp_path)):
        loaded = silpose.load(place)
        assert loaded.frames_per_second == 15 and loaded.tracker is None
        np.testing.assert_array_equal(
            loaded.predict(sequence.masks).x, model.predict(sequence.masks).x
        )


@pytest.mark.parametrize("kind", ["belief", "hypotheses"])
def test_saved_and_loaded_it_tracks_the_same(examples, kind, sequence, tmp_path):
    takes = examples[1]
    mixture = MixtureOfRegressors(4, shared=RidgeRegressor(damping=0.01))
    tracker = {
        "belief": BeliefTracker(keep=0.5),
        "hypotheses": MultipleHypothesisTracker(mixture, n_particles=50),
    }[kind].fit(takes)
    model = model_of(examples, RidgeRegressor(damping=0.01), tracker)
    model.save(tmp_path / "model.npz")
    track, again = (
        own.track(sequence.masks, frames_per_second=15) for own in (model, load(tmp_path))
    )
    np.testing.assert_array_equal(track.x, again.x)
    assert track.state == again.state


def test_what_two_parts_share_is_written_once(examples, model, tmp_path):
    mixture = MixtureOfRegressors(4, shared=RidgeRegressor(damping=0.01))
    tracker = MultipleHypothesisTracker(mixture).fit(examples[1])
    PoseModel(*(vars(model) | {"tracker": tracker}).values()).save(tmp_path / "model.npz")
    with np.load(tmp_path / "model.npz") as file:
        arrays = dict(file)
    header = json.loads(str(arrays.pop("header")))
    shared = [name for name in header["same_as"] if "basis" in name]
    assert shared and not set(shared) & set(arrays)
    large = [a.tobytes() for a in arrays.values() if a.size >= 1000]
    assert len(set(large)) == len(large)


def test_a_model_without_descriptor_predicts_from_descriptors(model, examples, tmp_path):
    PoseModel(None, model.regressor, ANGLES, 15.0).save(tmp_path / "model.npz")
    loaded, z = load(tmp_path), examples[1][0][0]
    np.testing.assert_array_equal(loaded.explain_descriptors(z).x, model.regressor.predict(z))
    with pytest.raises(InputError, match="cannot describe masks"):
        loaded.predict(np.ones((1, 9, 9)))


def test_a_file_that_is_no_model_is_named(tmp_path):
    with pytest.raises(InputError, match="there is no model"):
        load(tmp_path)
    other = io.BytesIO()
    np.savez(other, a=np.ones(3))
    for content in (b"", b"nonsense", other.getvalue()):
        (tmp_path / "model.npz").write_bytes(content)
        with pytest.raises(InputError, match=r"model\.npz' is no silpose model"):
            load(tmp_path)


def test_another_format_asks_for_training_again(model, tmp_path):
    model.save(tmp_path / "model.npz")
    arrays = dict(np.load(tmp_path / "model.npz"))
    header = json.loads(str(arrays["header"]))
    assert header["format"] == 7
    header["format"] = 99
    np.savez(tmp_path / "model.npz", **(arrays | {"header": np.array(json.dumps(header))}))
    with pytest.raises(InputError, match="format 99"):
        load(tmp_path)


def test_a_place_that_cannot_be_written_to_is_named(model, read_only):
    with pytest.raises(InputError, match=r"cannot write .*model\.npz"):
        model.save(read_only / "model.npz")


def test_what_was_changed_after_it_was_written_is_refused(model, tmp_path):
    model.save(tmp_path / "model.npz")
    arrays = dict(np.load(tmp_path / "model.npz"))
    arrays["regressor.intercept_"] = arrays["regressor.intercept_"] + 1
    np.savez(tmp_path / "model.npz", **arrays)
    with pytest.raises(InputError, match="is damaged, or was changed after it was written"):
        load(tmp_path)


def test_a_model_that_a_stranger_wrote_is_refused_with_a_reason(tmp_path):
    header = {"regressor": "os.system", "tracker": None, "space": "angles"}
    write_model_file(tmp_path / "model.npz", header, {})
    with pytest.raises(InputError, match="holds no model that silpose can use"):
        load(tmp_path)

import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.model.confidence.evidence import EVIDENCE, TrainingExamples, looks_of
from silpose.model.confidence.odd_frames import facts_of


@pytest.fixture(scope="module")
def parts(small):
    (z, x), take = small.described.train[0], small.described.data.train[0]
    return z, x, facts_of(list(take.masks))[1]


@pytest.fixture(scope="module")
def examples(parts):
    return TrainingExamples.of(*parts, ANGLES)


def named(evidence):
    return dict(zip(EVIDENCE, evidence.T, strict=True))


def test_true_poses_are_less_strange_than_others(parts, examples):
    z, x, facts = parts
    own, other = (examples.evidence(z, poses, facts) for poses in (x, np.roll(x, 20, axis=0)))
    assert own.shape == (60, len(EVIDENCE))
    for name in ("descriptor_joints", "descriptor_best", "look_joints", "pose_look"):
        assert (named(own)[name] <= named(other)[name]).mean() > 0.95
    np.testing.assert_array_equal(named(own)["look_distance"], named(other)["look_distance"])


def test_short_headings_are_strange(parts, examples):
    z, x, facts = parts
    short = x.copy()
    short[:, :2] *= 0.4
    evidence = named(examples.evidence(z, short, facts))
    np.testing.assert_allclose(evidence["norm_low"], 0.6)
    np.testing.assert_allclose(evidence["norm_high"], 0, atol=1e-6)


def test_without_masks_looks_are_no_evidence(parts):
    z, x, _ = parts
    evidence = named(TrainingExamples.of(z, x, None, ANGLES).evidence(z, x, None))
    assert np.ptp(evidence["look_distance"]) == 0
    assert (evidence["cut"] == 0).all()


def test_many_frames_are_judged_in_blocks(parts, examples):
    z, x, facts = parts
    x = 1.2 * x  # of poses that equal an example, the distance is rounding alone
    many = np.tile(np.arange(60), 12)
    evidence = examples.evidence(z[many], x[many], facts[many])
    np.testing.assert_allclose(evidence[-60:], evidence[:60], rtol=1e-3, atol=2e-3)


def test_no_frames():
    empty = TrainingExamples.of(np.ones((3, 4)), np.eye(55)[:3], None, ANGLES)
    assert empty.evidence(np.empty((0, 4)), np.empty((0, 55)), None).shape == (0, len(EVIDENCE))


def test_joined_examples_are_all_of_them(parts, examples):
    z, x, facts = parts
    halves = [TrainingExamples.of(z[s], x[s], facts[s], ANGLES) for s in (slice(20), slice(20, 60))]
    joined = TrainingExamples.concatenate(halves)
    np.testing.assert_array_equal(joined.joints, examples.joints)
    assert joined.space is ANGLES


def test_looks_have_unit_length(parts):
    looks = looks_of(parts[2], 60)
    assert looks.shape == (60, 144)
    np.testing.assert_allclose(np.linalg.norm(looks, axis=1), 1, rtol=1e-5)

import numpy as np
import pytest

from silpose.model.confidence.odd_frames import (
    RENDERED,
    facts_of,
    frames_of_descriptors,
    frames_of_masks,
)
from silpose.model.confidence.odd_masks import NOBODY, ODD


@pytest.fixture(scope="module")
def frames(small):
    data, descriptor = small.described.data, small.described.descriptor
    return frames_of_masks(data.train, descriptor, 10, 60, np.random.default_rng(0))


def test_clean_frames_come_first_and_are_those_of_the_takes(small, frames):
    assert frames.kinds[:10] == ["clean"] * 10
    assert not frames.odd[:10].any() and frames.odd[10:].all()
    x = np.concatenate([take.x for take in small.described.data.train])
    z = np.concatenate([z for z, _ in small.described.train])
    for own_z, own_x in zip(frames.z[:10], frames.x[:10], strict=True):
        row = np.flatnonzero((x == own_x).all(axis=1))
        np.testing.assert_allclose(z[row[0]], own_z)


def test_every_kind_is_drawn(frames):
    assert set(frames.kinds) == {"clean", *ODD, *RENDERED}
    nobody = np.isin(frames.kinds, NOBODY)
    np.testing.assert_array_equal(np.isnan(frames.x).all(axis=1), nobody)
    assert frames.facts is not None and frames.facts.seen.all()


def test_some_of_the_frames(frames):
    some = frames[np.array([3, 40])]
    assert some.kinds == [frames.kinds[3], frames.kinds[40]]
    np.testing.assert_array_equal(some.z[1], frames.z[40])


def test_descriptors_alone(small):
    z, x = small.described.joined("train")
    frames = frames_of_descriptors(z, x, 20, 40, np.random.default_rng(0))
    assert frames.z.shape == (60, 40) and frames.facts is None
    np.testing.assert_allclose(frames.z.sum(axis=1), 1)
    assert np.isnan(frames.x).all(axis=1).sum() == 10


def test_facts_of_masks_choose_the_largest(sequence):
    both = np.hstack([sequence.masks[0], sequence.masks[12]])
    masks, facts = facts_of([both])
    assert facts.people.tolist() == [2]
    assert masks[0].sum() == max(sequence.masks[0].sum(), sequence.masks[12].sum())

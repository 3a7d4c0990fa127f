import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.descriptor import ShapeContextHistogram
from silpose.model.described_masks import describe_masks, mask_options, see_masks
from silpose.silhouette.masks import MaskSource


@pytest.fixture(scope="module")
def descriptor(sequence):
    return ShapeContextHistogram(codebook_size=20).fit(sequence.masks)


def test_what_shows_nobody_has_no_descriptor(descriptor, sequence):
    masks = list(sequence.masks[:4])
    masks[1] = 0 * masks[1]
    masks[2] = 0 * masks[2]
    masks[2][3:5, 3:5] = 1  # a speck
    described = describe_masks(descriptor, masks, MaskSource(blank="nan"))
    unseen = np.array([False, True, True, False])
    assert described.facts.seen.tolist() == (~unseen).tolist()
    np.testing.assert_array_equal(np.isnan(described.z).all(axis=1), unseen)
    assert [len(points) > 0 for points in described.points] == (~unseen).tolist()


def test_specks_beside_the_person_change_nothing(descriptor, sequence):
    specks = sequence.masks[:3].copy()
    specks[:, 2:4, 2:4] = 1
    clean = describe_masks(descriptor, sequence.masks[:3], MaskSource())
    described = describe_masks(descriptor, specks, MaskSource())
    np.testing.assert_array_equal(described.z, clean.z)
    assert (described.facts.dropped == 1).all()


def test_a_long_take_is_described_in_blocks(descriptor, sequence, monkeypatch):
    monkeypatch.setattr("silpose.model.described_masks._BLOCK", 3)
    described = describe_masks(descriptor, sequence.masks[:8], MaskSource())
    np.testing.assert_array_equal(described.z, descriptor.transform(sequence.masks[:8]))


def test_a_blank_mask_is_an_error_unless_it_is_asked_for(sequence):
    masks = [sequence.masks[0], 0 * sequence.masks[0]]
    with pytest.raises(InputError, match="'frame 1' has no foreground"):
        see_masks(masks, mask_options("error", None, {}))
    assert see_masks(masks, mask_options("nan", None, {}))[1].blank.tolist() == [False, True]

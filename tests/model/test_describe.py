import numpy as np
import pytest
from synthetic import motion

from silpose.core.errors import InputError
from silpose.dataset import LazyMasks, photograph
from silpose.descriptor import ShapeContextHistogram
from silpose.model import describe as descriptors
from silpose.model.describe import describe, learn_descriptor
from silpose.model.descriptor_cache import DescriptorCache


@pytest.fixture(scope="module")
def takes(body, camera):
    motions = [
        motion(name, frames, seed=frames) for name, frames in (("a", 30), ("b", 7), ("c", 20))
    ]
    return [photograph(own, body, camera, hold=False) for own in motions]


@pytest.fixture(scope="module")
def histogram(takes):
    return learn_descriptor(ShapeContextHistogram(codebook_size=20), takes)


def test_blocks_and_processes_change_nothing(takes, histogram, monkeypatch):
    expected = [histogram.transform(np.asarray(take.masks)) for take in takes]
    monkeypatch.setattr(descriptors, "_BLOCK", 9)
    here = describe(histogram, takes)
    monkeypatch.setattr(descriptors, "_FEW", 0)
    elsewhere = describe(histogram, takes)
    for one, other, z in zip(here, elsewhere, expected, strict=True):
        np.testing.assert_array_equal(one, z)
        np.testing.assert_array_equal(other, z)


def test_no_more_than_a_block_of_masks_is_held(takes, histogram, monkeypatch):
    held = []
    walk = LazyMasks.__iter__

    def counted(self):
        held.append(len(self))
        return walk(self)

    monkeypatch.setattr(LazyMasks, "__iter__", counted)
    monkeypatch.setattr(descriptors, "_BLOCK", 8)
    describe(histogram, takes)
    assert max(held) == 8 and sum(held) == 57


def test_a_codebook_is_learnt_from_an_even_share(takes, monkeypatch):
    seen = []

    def fit(self, masks, y=None):
        seen.append(len(masks))
        return self

    monkeypatch.setattr(ShapeContextHistogram, "fit", fit)
    monkeypatch.setattr(descriptors, "_CODEBOOK_MASKS", 20)
    learn_descriptor(ShapeContextHistogram(), takes)
    assert seen == [19]  # every third of 57


def test_a_shelf_gives_back_what_was_stored(tmp_path, takes, histogram):
    shelf = DescriptorCache.of(tmp_path / "kept", {"seed": 0}, [])
    lengths = [len(take) for take in takes]
    assert shelf.fetch(lengths) is None
    z = describe(histogram, takes)
    shelf.store(histogram, z)
    kept, found = shelf.fetch(lengths)
    for one, other in zip(z, found, strict=True):
        np.testing.assert_array_equal(one, other)
    np.testing.assert_array_equal(kept.codebook_, histogram.codebook_)
    assert [f.name for f in (tmp_path / "kept").iterdir()] == [shelf.file.name]


def test_whatever_changes_changes_the_place(tmp_path):
    (tmp_path / "a.bvh").write_text("one")
    files = [tmp_path / "a.bvh"]
    shelves = [
        DescriptorCache.of("kept", {"seed": 0}, files),
        DescriptorCache.of("kept", {"seed": 1}, files),
    ]
    (tmp_path / "a.bvh").write_text("other")
    shelves.append(DescriptorCache.of("kept", {"seed": 0}, files))
    assert len({shelf.file for shelf in shelves}) == 3


def test_a_damaged_shelf_is_named(tmp_path):
    shelf = DescriptorCache.of(tmp_path, {}, [])
    shelf.file.write_bytes(b"nonsense")
    with pytest.raises(InputError, match=r"is damaged .* remove it"):
        shelf.fetch([1])

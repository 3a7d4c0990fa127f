import numpy as np
import pytest
from synthetic import motion

from silpose.dataset import LazyMasks, render_take
from silpose.descriptor import ShapeContextHistogram
from silpose.model import describe as module
from silpose.model.describe import describe, fit_descriptor


@pytest.fixture(scope="module")
def takes(body, camera):
    motions = [
        motion(name, frames, seed=frames) for name, frames in (("a", 30), ("b", 7), ("c", 20))
    ]
    return [render_take(own, body, camera, now=False, held=False) for own in motions]


@pytest.fixture(scope="module")
def histogram(takes):
    return fit_descriptor(ShapeContextHistogram(codebook_size=20), takes)


def test_blocks_and_processes_change_nothing(takes, histogram, monkeypatch):
    expected = [histogram.transform(np.asarray(take.masks)) for take in takes]
    monkeypatch.setattr(module, "_BLOCK", 9)
    here = describe(histogram, takes)
    monkeypatch.setattr(module, "_FEW", 0)
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
    monkeypatch.setattr(module, "_BLOCK", 8)
    describe(histogram, takes)
    assert max(held) == 8 and sum(held) == 57


def test_a_codebook_is_fitted_to_an_even_share(takes, monkeypatch):
    seen = []

    def fit(self, masks, y=None):
        seen.append(len(masks))
        return self

    monkeypatch.setattr(ShapeContextHistogram, "fit", fit)
    monkeypatch.setattr(module, "_CODEBOOK_MASKS", 20)
    fit_descriptor(ShapeContextHistogram(), takes)
    assert seen == [19]  # every third of 57

import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.descriptor import ShapeContextHistogram
from silpose.model import DescriptorCache


@pytest.fixture(scope="module")
def described(sequence):
    """A fitted descriptor, and z of two takes."""
    histogram = ShapeContextHistogram(codebook_size=20)
    z = histogram.fit_transform(sequence.masks[:20])
    return histogram, [z[:12], z[12:]]


def test_what_was_stored_is_fetched(tmp_path, described):
    histogram, z = described
    cache = DescriptorCache.of(tmp_path / "cache", {"seed": 0}, [])
    assert cache.fetch([12, 8]) is None
    with cache.building():
        cache.store(histogram, z)
    cached, found = cache.fetch([12, 8])
    for one, other in zip(z, found, strict=True):
        np.testing.assert_array_equal(one, other)
    np.testing.assert_array_equal(cached.codebook_, histogram.codebook_)
    assert [f.name for f in (tmp_path / "cache").glob("*.npz")] == [cache.file.name]


def test_another_number_of_frames_is_not_what_was_stored(tmp_path, described):
    cache = DescriptorCache.of(tmp_path, {}, [])
    cache.store(*described)
    assert cache.fetch([12, 9]) is None


def test_whatever_changes_changes_the_file(tmp_path):
    (tmp_path / "a.bvh").write_text("one")
    files = [tmp_path / "a.bvh"]
    caches = [
        DescriptorCache.of("cache", {"seed": 0}, files),
        DescriptorCache.of("cache", {"seed": 1}, files),
    ]
    (tmp_path / "a.bvh").write_text("other")
    caches.append(DescriptorCache.of("cache", {"seed": 0}, files))
    assert len({cache.file for cache in caches}) == 3


def test_a_damaged_file_is_named_and_not_used(tmp_path, described):
    cache = DescriptorCache.of(tmp_path, {}, [])
    cache.store(*described)
    whole = cache.file.read_bytes()
    for damaged in (b"nonsense", b"", whole[: len(whole) // 2]):
        cache.file.write_bytes(damaged)
        with pytest.warns(UserWarning, match=r"is damaged .* described anew"):
            assert cache.fetch([12, 8]) is None
    np.savez(cache.file, other=np.zeros(3))
    with pytest.warns(UserWarning, match=r"is damaged .* described anew"):
        assert cache.fetch([12, 8]) is None


def test_one_builds_while_the_others_wait(tmp_path):
    inside, most = [], []

    def build(_):
        with DescriptorCache.of(tmp_path / "cache", {}, []).building():
            inside.append(1)
            most.append(len(inside))
            time.sleep(0.02)
            inside.pop()

    with ThreadPoolExecutor(4) as pool:
        list(pool.map(build, range(4)))
    assert most == [1, 1, 1, 1]


def test_a_folder_that_cannot_be_written_to_is_named(read_only):
    cache = DescriptorCache.of(read_only / "cache", {}, [])
    wrong = pytest.raises(InputError, match=r"cannot write to .*choose another dataset\.cache")
    with wrong, cache.building():
        pass

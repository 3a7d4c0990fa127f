import io
import zipfile

import numpy as np
import pytest

from silpose.core import array_files
from silpose.core.array_files import TooLarge, read_npz, wrong_size


def npy(shape, held=64):
    """An array that claims a shape, and has so many bytes."""
    text = f"{{'descr': '|u1', 'fortran_order': False, 'shape': {shape}, }}".ljust(117) + "\n"
    return b"\x93NUMPY\x01\x00" + len(text).to_bytes(2, "little") + text.encode() + bytes(held)


def test_arrays_are_read(tmp_path):
    np.savez(tmp_path / "a.npz", a=np.arange(3), b="word")
    assert read_npz(tmp_path / "a.npz")["a"].tolist() == [0, 1, 2]
    assert str(read_npz(tmp_path / "a.npz")["b"]) == "word"


def test_a_claimed_size_is_seen_before_memory_is_taken(tmp_path):
    with zipfile.ZipFile(tmp_path / "a.npz", "w") as archive:
        archive.writestr("a.npy", npy((10**6, 10**6)))
    with pytest.raises(ValueError, match="'a' claims shape"):
        read_npz(tmp_path / "a.npz")
    assert "claims shape" in wrong_size(io.BytesIO(npy((99, 99))), 200)
    assert wrong_size(io.BytesIO(npy((8, 8))), 200) == ""


def test_an_archive_that_unpacks_to_more_than_memory_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(array_files, "LARGEST", 10_000)
    np.savez_compressed(tmp_path / "one.npz", a=np.zeros(20_000, np.uint8))
    np.savez_compressed(tmp_path / "many.npz", **{f"a{k}": np.zeros(9_000) for k in range(1)})
    np.savez_compressed(tmp_path / "sum.npz", a=np.zeros(1_000), b=np.zeros(1_000))
    np.savez(tmp_path / "plain.npz", a=np.zeros(20_000, np.uint8))
    for name in ("one", "many", "sum"):
        with pytest.raises(ValueError, match="more than 0"):
            read_npz(tmp_path / f"{name}.npz")
    assert read_npz(tmp_path / "plain.npz")["a"].size == 20_000
    assert issubclass(TooLarge, ValueError)


@pytest.mark.parametrize("content", [b"", b"PK\x03\x04junk", npy((8, 8))])
def test_no_archive(tmp_path, content):
    (tmp_path / "a.npz").write_bytes(content)
    with pytest.raises(ValueError):
        read_npz(tmp_path / "a.npz")


def test_nothing_pickled_is_opened(tmp_path):
    np.savez(tmp_path / "a.npz", a=np.array([print], dtype=object))
    with pytest.raises(ValueError, match="allow_pickle"):
        read_npz(tmp_path / "a.npz")

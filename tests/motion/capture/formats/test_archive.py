import zipfile

import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.motion.capture.formats.archive import Archive


@pytest.mark.parametrize("content", [b"", b"PK\x03\x04junk", b"\x93NUMPY\x01\x00", b"\x80\x04N."])
def test_no_archive(tmp_path, content):
    (tmp_path / "odd.npz").write_bytes(content)
    with pytest.raises(InputError, match=r"odd\.npz: is no \.npz archive"):
        Archive(tmp_path / "odd.npz")


def test_a_single_array(tmp_path):
    with open(tmp_path / "odd.npz", "wb") as stream:
        np.save(stream, np.zeros(3))
    with pytest.raises(InputError, match="a single array"):
        Archive(tmp_path / "odd.npz")


@pytest.mark.parametrize("compressed", [True, False])
def test_every_damage_is_named(tmp_path, compressed):
    file = tmp_path / "odd.npz"
    (np.savez_compressed if compressed else np.savez)(file, a=np.arange(500.0), b=np.eye(4))
    whole = file.read_bytes()
    for at in range(0, len(whole), 97):
        for content in (whole[:at], whole[:at] + b"\xff\x00\xff" + whole[at + 3 :]):
            file.write_bytes(content)
            try:
                with Archive(file) as archive:
                    archive.numbers("a")
            except InputError as error:
                assert "odd.npz: " in str(error) and "\n" not in str(error)


def test_a_claimed_size_costs_no_memory(tmp_path):
    header = "{'descr': '<f8', 'fortran_order': False, 'shape': (1000000000, 1000), }"
    text = header.ljust(118) + "\n"
    array = b"\x93NUMPY\x01\x00" + len(text).to_bytes(2, "little") + text.encode() + bytes(64)
    with zipfile.ZipFile(tmp_path / "odd.npz", "w") as archive:
        archive.writestr("a.npy", array)
    with Archive(tmp_path / "odd.npz") as stored, pytest.raises(InputError, match="claims shape"):
        stored.numbers("a")


def test_too_large(tmp_path, monkeypatch):
    np.savez(tmp_path / "a.npz", a=np.zeros(500))
    monkeypatch.setattr("silpose.core.array_files.LARGEST", 1000)
    with Archive(tmp_path / "a.npz") as stored, pytest.raises(InputError, match="shorter takes"):
        stored.numbers("a")


def test_numbers_keys_and_lacks(tmp_path):
    np.savez(tmp_path / "a.npz", a=np.arange(3), c=np.array(1j))
    with Archive(tmp_path / "a.npz") as stored:
        assert stored.keys == ("a", "c") and stored.first(("b", "c", "a")) == "c"
        assert stored.first(("b",)) is None
        np.testing.assert_array_equal(stored.numbers("a"), [0.0, 1, 2])
        with pytest.raises(InputError, match="'c' holds complex128, not numbers"):
            stored.numbers("c")
        assert "has no 'b', only a, c; add rows" in str(stored.lacks(("b",), "rows"))

"""NumPy's files from anywhere: nothing pickled is opened, and no size is believed unseen."""

from __future__ import annotations

import tokenize
import zipfile
import zlib
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

LARGEST = 2_000_000_000
"""Bytes of the largest array that is read from a compressed archive."""

DAMAGE = (
    zipfile.BadZipFile, zlib.error, ValueError, OSError, EOFError, MemoryError,
    NotImplementedError, RuntimeError, KeyError, SyntaxError, tokenize.TokenError,
)  # fmt: skip
"""What NumPy and Python raise for damaged archives."""


class TooLarge(ValueError):
    """An array that has, or claims to have, more bytes than will be read."""


def read_npz(file: str | Path) -> dict[str, NDArray[Any]]:
    """Read all arrays of an archive.

    Parameters
    ----------
    file : path

    Returns
    -------
    arrays : dict of str to ndarray

    Raises
    ------
    ValueError
        If it is no archive, or damaged, or holds pickled objects, or more than fits into memory.
    """
    try:
        stored = np.load(file, allow_pickle=False)
        if not isinstance(stored, np.lib.npyio.NpzFile):
            raise ValueError("it is a single array")
        with stored:
            check_members(stored)
            return dict(stored)
    except DAMAGE as error:
        raise ValueError(first_line(error)) from error


def check_members(stored: np.lib.npyio.NpzFile) -> None:
    """Refuse an open archive if an array in it has or claims a size that it must not have."""
    archive = stored.zip
    assert archive is not None  # it is open
    total = 0
    for member in archive.infolist():
        with archive.open(member) as stream:
            if wrong := wrong_size(stream, member.file_size, compressed=_is_compressed(member)):
                raise TooLarge(f"'{member.filename.removesuffix('.npy')}' {wrong}")
        total += member.file_size if _is_compressed(member) else 0
    if total > LARGEST:
        raise TooLarge(f"its arrays have {total / 1e9:.1f} GB, more than {LARGEST / 1e9:.0f}")


def _is_compressed(member: zipfile.ZipInfo) -> bool:
    return member.compress_size < member.file_size


def wrong_size(stream: IO[bytes], held: int, compressed: bool = True) -> str:
    """Say what is wrong with the size of an array before it is read; empty if nothing.

    Parameters
    ----------
    stream : file
        An ``.npy``, at its beginning; its header is read.
    held : int
        Bytes that there are, or that the archive claims.
    compressed : bool, default=True
        Whether they take less than that on the disk.
    """
    if compressed and held > LARGEST:
        return f"has {held / 1e9:.1f} GB, more than {LARGEST / 1e9:.0f}"
    version = np.lib.format.read_magic(stream)
    headers = np.lib.format
    read = headers.read_array_header_1_0 if version == (1, 0) else headers.read_array_header_2_0
    shape, _, dtype = read(stream)
    if not dtype.hasobject and np.prod(shape, dtype=float) * dtype.itemsize > held - stream.tell():
        return f"claims shape {shape}, but the file is damaged or truncated"
    return ""


def first_line(error: Exception) -> str:
    """Shorten the words of an error to their first line."""
    return str(error).splitlines()[0] if str(error) else type(error).__name__

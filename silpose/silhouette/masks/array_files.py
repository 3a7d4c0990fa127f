"""Arrays of masks in files of NumPy."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from silpose.core.array_files import DAMAGE, TooLarge, check_members, first_line, wrong_size
from silpose.core.errors import InputError
from silpose.silhouette.masks.natural_order import in_natural_order, without_numbers
from silpose.silhouette.masks.picture import Pixels

ARRAYS = (".npy", ".npz")
"""Suffixes of arrays in files."""

_USUAL_NAMES = ("masks", "mask", "silhouettes", "silhouette", "segmentation", "data")
_LISTED = 6  # names in a message


def read_array_file(file: Path) -> Pixels:
    """Read the masks of an ``.npy`` or ``.npz`` file.

    Raises
    ------
    InputError
        If it is damaged, holds pickled objects, or several arrays of which none has a usual name.
    """
    try:
        if _begins(file, b"\x93N"):
            with file.open("rb") as stream:
                if wrong := wrong_size(stream, file.stat().st_size, compressed=False):
                    raise OSError(wrong)
        loaded = np.load(file, allow_pickle=False)
        if isinstance(loaded, np.ndarray):
            return loaded
        with loaded:
            check_members(loaded)
            return _masks(file, loaded)
    except InputError:
        raise
    except TooLarge as error:
        raise InputError(
            f"'{file}' {error}: save it by np.save, or split it into shorter takes"
        ) from None
    except DAMAGE as error:
        if not isinstance(error, ValueError):
            raise InputError(
                f"'{file}' is incomplete or damaged ({first_line(error)}): remove it, or write it "
                "anew"
            ) from None
        if not _begins(file, b"\x93N", b"PK"):
            raise InputError(
                f"'{file}' is no array of NumPy, or damaged: save the masks by "
                "np.save('masks.npy', masks)"
            ) from None
        raise InputError(
            f"'{file}' holds pickled objects, which could run any program, or is damaged: save "
            "masks of one size as one array, np.save('masks.npy', np.stack(masks)), or each as an "
            "image"
        ) from None


def _masks(file: Path, held: Mapping[str, Pixels]) -> Pixels:
    """Choose the array that is the masks, or join arrays that are a mask each."""
    names = list(held)
    if len(names) == 1:
        return held[names[0]]
    if usual := [name for name in _USUAL_NAMES if name in names]:
        return held[usual[0]]
    arrays = [held[names[k]] for k in in_natural_order(names)]
    shapes = {array.shape for array in arrays}
    numbered = len({without_numbers(name) for name in names}) == 1
    if len(arrays) > 1 and numbered and all(len(shape) == 2 for shape in shapes):
        if len(shapes) == 1:
            return np.stack(arrays)
        raise InputError(
            f"'{file}' holds {len(names)} masks of several sizes: save each as an image"
        )
    stacks = [array for array in arrays if array.ndim > 2]
    if len(stacks) == 1:
        return stacks[0]
    listed = ", ".join(names[:_LISTED]) + (" and more" if len(names) > _LISTED else "")
    raise InputError(
        f"'{file}' holds the arrays {listed or '(none)'}: name the one of the masks 'masks'"
    )


def _begins(file: Path, *beginnings: bytes) -> bool:
    with file.open("rb") as stream:
        return stream.read(2) in beginnings

"""The file of a model: an ``.npz`` without pickled objects, which begins with a header."""

from __future__ import annotations

import json
from collections.abc import Mapping
from hashlib import sha256
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from silpose.core.array_files import read_npz
from silpose.core.atomic_files import writing
from silpose.core.errors import InputError
from silpose.core.serialisation import State

FORMAT = 7
_WITHOUT_DIGEST = 6  # the format before, which is read as well
_LARGE = 1000  # numbers from which an array is not written twice


def write_model_file(path: str | Path, header: Mapping[str, object], state: State) -> None:
    """Write a model's file, under its name only once it is complete.

    Parameters
    ----------
    path : path
    header : mapping
        Plain values; format and version are added.
    state : dict
        Arrays, numbers and strings by name.
    """
    arrays, same_as = _distinct(state)
    whole = {"format": FORMAT, "silpose": version("silpose"), "same_as": same_as, **header}
    whole["digest"] = _digest(whole, arrays)
    arrays["header"] = np.array(json.dumps(whole))
    with writing(Path(path), check=read_model_file) as partial, partial.open("wb") as file:
        np.savez_compressed(file, **arrays)  # type: ignore[arg-type]


def read_model_file(path: str | Path) -> tuple[dict[str, Any], State]:
    """Read a model's file.

    Parameters
    ----------
    path : path
        The ``.npz``, or the folder of the run that holds it.

    Returns
    -------
    header : dict
    state : dict of ndarray

    Raises
    ------
    InputError
        If there is no such file, or it is no model, or one of another format, or not as it was
        written.
    """
    path = Path(path)
    if path.is_dir():
        path = path / "model.npz"
    if not path.is_file():
        raise InputError(f"there is no model '{path}': give a run's model.npz")
    try:
        arrays: State = read_npz(path)
        header = json.loads(str(arrays.pop("header")))
        written_by = f"format {header['format']} of silpose {header['silpose']}"
    except (ValueError, KeyError, TypeError, RecursionError) as error:
        raise InputError(
            f"'{path}' is no silpose model, or damaged ({error}): give a run's model.npz"
        ) from error
    if header["format"] not in (FORMAT, _WITHOUT_DIGEST):
        raise InputError(
            f"'{path}' has {written_by}; this version reads format {FORMAT}: train the model again"
        )
    written = header.pop("digest", None)
    if header["format"] == FORMAT and written != _digest(header, arrays):
        raise InputError(
            f"'{path}' is damaged, or was changed after it was written: copy it again, or train "
            "the model again"
        )
    return header, arrays | {name: arrays[other] for name, other in header["same_as"].items()}


def _digest(header: Mapping[str, object], arrays: State) -> str:
    """Digest of all that a file holds: swapped, changed or missing arrays give another one."""
    digest = sha256(json.dumps(header, sort_keys=True).encode())
    for name in sorted(arrays):
        digest.update(repr((name, *_identity(np.asarray(arrays[name])))).encode())
    return digest.hexdigest()


def _identity(array: NDArray[Any]) -> tuple[object, ...]:
    return array.dtype.str, array.shape, sha256(array.tobytes()).digest()


def _distinct(state: State) -> tuple[State, dict[str, str]]:
    """Keep large arrays once, and name those that equal another one.

    Several parts of a model may hold the same basis of training examples.
    """
    first: dict[tuple[object, ...], str] = {}
    arrays: State = {}
    same_as: dict[str, str] = {}
    for name, value in state.items():
        array = np.asarray(value)
        key = _identity(array)
        if array.size >= _LARGE and key in first:
            same_as[name] = first[key]
        else:
            first[key] = name
            arrays[name] = array
    return arrays, same_as

"""Results that a folder holds from one run to the next, named by all that they depend on."""

from __future__ import annotations

import hashlib
import json
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass
from functools import cache, partial
from importlib.metadata import version
from pathlib import Path
from types import FunctionType
from typing import Any, Self

import numpy as np
from sklearn.base import BaseEstimator

from silpose.core.array_files import read_npz
from silpose.core.atomic_files import writing
from silpose.core.digest import digest
from silpose.core.errors import InputError
from silpose.core.one_builder import one_builder
from silpose.core.pose_space import PoseSpace
from silpose.core.serialisation import State

_LIBRARIES = ("mannequin-x", "numba", "numpy", "opencv-python-headless", "scikit-learn", "scipy")
_NAME = "known as"  # in a file, so that a copy under another name is not used


@dataclass(frozen=True)
class KnownResults:
    """Plain values, or arrays, that were computed before, one file each, which holds its name.

    Attributes
    ----------
    folder : Path or None, default=None
        Without one, everything is computed whenever it is asked for.
    given : str, default=""
        Name of what all results depend on, such as the data.
    """

    folder: Path | None = None
    given: str = ""

    def depending_on(self, *more: Any) -> Self:
        """Return the same for results that depend on more: see `described`.

        On what cannot be described, such as a generator of random numbers, nothing is remembered.
        """
        if self.folder is None:
            return self
        try:
            return type(self)(self.folder, digest([self.given, *map(described, more)]))
        except TypeError:
            return type(self)()

    def recall(self, compute: Callable[[], Any], *depends_on: Any) -> Any:
        """Return what is known, or compute it, and know it from now on.

        Parameters
        ----------
        compute : callable
            Returns numbers, texts, lists and mappings of these.
        *depends_on
            All that the result depends on, besides the package's own code: see `described`.

        Returns
        -------
        result : plain value
            Where it cannot be kept, a warning says so.
        """

        def as_text() -> State:
            return {"json": np.array(json.dumps(compute(), default=_plain))}

        known = self._of(*depends_on, "json")
        return compute() if known.folder is None else json.loads(str(known._state(as_text)["json"]))

    def recall_arrays(self, compute: Callable[[], State], *depends_on: Any) -> State:
        """Return arrays that are known, or compute them, as `recall` does with plain values."""
        known = self._of(*depends_on)
        return compute() if known.folder is None else known._state(compute)

    def _of(self, *depends_on: Any) -> Self:
        return self if self.folder is None else self.depending_on(_code(), *depends_on)

    def _state(self, compute: Callable[[], State]) -> State:
        assert self.folder is not None
        file = self.folder / f"{self.given}.npz"
        with one_builder(file) as kept:
            return _kept(file, compute) if kept else compute()


def _kept(file: Path, compute: Callable[[], State]) -> State:
    try:
        if file.is_file():
            return _read(file)
    except (OSError, ValueError) as error:
        warnings.warn(f"'{file}' is damaged ({error}): it is made anew", stacklevel=5)
    result = compute()
    try:
        with writing(file) as temporary, temporary.open("wb") as stream:
            np.savez(stream, **result | {_NAME: np.array(file.stem)})  # type: ignore[arg-type]
    except (InputError, OSError) as error:  # such as of a full disk
        warnings.warn(f"{error}; the run goes on without it", stacklevel=5)
        return result
    return _read(file)  # now and later the same, to the last digit


def _read(file: Path) -> State:
    """Read arrays, whose checksums NumPy's archives hold, unless they are those of other data."""
    arrays: State = read_npz(file)
    if str(arrays.pop(_NAME, "")) != file.stem:
        raise ValueError("it holds another result")
    return arrays


def described(thing: Any) -> Any:
    """Describe what a result depends on by plain values.

    Parameters
    ----------
    thing : plain value, array, function, estimator, pose space, dataclass, or collection of these
        Of a function the name counts, of an estimator its parameters and not what was fitted.

    Raises
    ------
    TypeError
        If it is none of these, so that nothing is left out by mistake.
    """
    if thing is None or isinstance(thing, bool | int | float | str):
        return thing
    if isinstance(thing, np.generic):
        return thing.item()
    if isinstance(thing, np.ndarray):
        content = hashlib.sha256(np.ascontiguousarray(thing).data).hexdigest()
        return [str(thing.dtype), list(thing.shape), content]
    if isinstance(thing, partial):
        return ["partial", described(thing.func), described(thing.args), described(thing.keywords)]
    if isinstance(thing, FunctionType):
        if thing.__closure__ or "<lambda>" in thing.__qualname__:
            raise TypeError(f"{thing.__qualname__} may depend on anything")
        return f"{thing.__module__}.{thing.__qualname__}"
    if isinstance(thing, PoseSpace):
        return thing.name
    if isinstance(thing, BaseEstimator):
        return [type(thing).__qualname__, described(thing.get_params(deep=False))]
    if is_dataclass(thing) and not isinstance(thing, type):
        own = {each.name: getattr(thing, each.name) for each in fields(thing)}
        return [type(thing).__qualname__, described(own)]
    if isinstance(thing, Mapping):
        return {str(key): described(value) for key, value in thing.items()}
    if isinstance(thing, Sequence):
        return [described(each) for each in thing]
    raise TypeError(f"cannot tell what {type(thing).__qualname__} depends on")


@cache
def _code() -> str:
    """Name the package's own code and the libraries it computes with: others, other results."""
    every = sorted(Path(__file__).parents[1].rglob("*.*"))
    files = [file for file in every if file.suffix in (".py", ".yaml", ".npz")]
    code = [hashlib.sha256(file.read_bytes()).hexdigest() for file in files]
    return digest([code, [version(name) for name in _LIBRARIES]])


def _plain(value: Any) -> Any:
    if isinstance(value, np.generic):
        return value.item()
    raise TypeError(f"{type(value).__qualname__} is no plain value")

"""Descriptors cached on disk, valid as long as nothing they depend on has changed."""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Self
from zipfile import BadZipFile

import numpy as np

from silpose.core.array_files import read_npz
from silpose.core.atomic_files import writing
from silpose.core.digest import digest
from silpose.core.one_builder import one_builder
from silpose.core.types import Array
from silpose.descriptor import ShapeContextHistogram

DESCRIPTORS = 2
"""To be raised when masks or descriptors change for the same settings."""


@dataclass(frozen=True)
class DescriptorCache:
    """One file in a folder, named by everything that descriptors depend on.

    Attributes
    ----------
    file : Path
    """

    file: Path

    @classmethod
    def of(cls, folder: str | Path, settings: Any, files: Iterable[Path]) -> Self:
        """Name the cache by what descriptors depend on.

        Parameters
        ----------
        folder : path
        settings : plain values, lists and mappings of them
        files : iterable of Path
            Files that masks are made from.
        """
        return cls(Path(folder) / f"{digest([DESCRIPTORS, settings], files)}.npz")

    def fetch(self, lengths: Sequence[int]) -> tuple[ShapeContextHistogram, list[Array]] | None:
        """Read the cache.

        Parameters
        ----------
        lengths : sequence of int
            Frames of each take.

        Returns
        -------
        descriptor : ShapeContextHistogram
            Fitted.
        z : list of ndarray, each (F, d)
            Instead of both, None where nothing is cached. A file that is damaged is none, and a
            warning names it.
        """
        if not self.file.is_file():
            return None
        try:
            arrays = read_npz(self.file)
            z = arrays.pop("z")
            descriptor = ShapeContextHistogram.from_arrays(arrays)
        except (OSError, EOFError, ValueError, KeyError, TypeError, BadZipFile) as error:
            reason = f"{type(error).__name__}: {error}"
            warnings.warn(
                f"'{self.file}' is damaged ({reason}): masks are described anew", stacklevel=2
            )
            return None
        if len(z) != sum(lengths):
            return None
        return descriptor, np.split(z, np.cumsum(lengths)[:-1])

    @contextmanager
    def building(self) -> Iterator[None]:
        """Let one process alone build the cache, as of `one_builder`."""
        with one_builder(self.file):
            yield

    def store(self, descriptor: ShapeContextHistogram, z: Sequence[Array]) -> None:
        """Write the fitted descriptor and z (F, d) of every take, while `building`."""
        with writing(self.file) as path:
            np.savez(path, z=np.concatenate(z), **descriptor.to_arrays())

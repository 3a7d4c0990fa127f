"""Descriptors cached on disk, valid as long as nothing they depend on has changed."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Self

import numpy as np

from silpose.core.array_files import read_npz
from silpose.core.atomic_files import writing
from silpose.core.errors import InputError
from silpose.core.types import Array
from silpose.descriptor import ShapeContextHistogram
from silpose.model.digest import digest

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
            Instead of both, None where nothing is cached.
        """
        if not self.file.is_file():
            return None
        try:
            arrays = read_npz(self.file)
            z = arrays.pop("z")
        except (KeyError, ValueError) as error:
            raise InputError(f"'{self.file}' is damaged ({error}): remove it") from error
        if len(z) != sum(lengths):
            return None
        descriptor = ShapeContextHistogram.from_arrays(arrays)
        return descriptor, np.split(z, np.cumsum(lengths)[:-1])

    def store(self, descriptor: ShapeContextHistogram, z: Sequence[Array]) -> None:
        """Write the fitted descriptor and z (F, d) of every take."""
        try:
            self.file.parent.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise InputError(
                f"cannot write to '{self.file.parent}' ({error.strerror}): "
                "choose another dataset.cache"
            ) from error
        with writing(self.file) as path:
            np.savez(path, z=np.concatenate(z), **descriptor.to_arrays())

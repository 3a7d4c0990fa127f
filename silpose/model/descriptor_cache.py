"""Descriptors kept on disk, and taken from there as long as nothing they depend on has changed."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from silpose.core.errors import InputError
from silpose.descriptor import ShapeContextHistogram

Array = NDArray[np.float64]

_FORMAT = 1  # to be raised when masks or descriptors change for the same settings


@dataclass(frozen=True)
class DescriptorCache:
    """One place in a folder, named by everything that descriptors depend on.

    Attributes
    ----------
    file : Path
    """

    file: Path

    @classmethod
    def of(cls, folder: str | Path, settings: Any, files: Iterable[Path]) -> DescriptorCache:
        """Name the place by settings (of plain values) and the files that are read."""
        stats = [(str(f), f.stat().st_size, f.stat().st_mtime_ns) for f in files]
        key = json.dumps([_FORMAT, settings, stats], sort_keys=True)
        return cls(Path(folder) / f"{hashlib.sha256(key.encode()).hexdigest()[:20]}.npz")

    def fetch(self, lengths: Sequence[int]) -> tuple[ShapeContextHistogram, list[Array]] | None:
        """Give the fitted descriptor and z (F, d) of every sequence; None if they are not kept."""
        if not self.file.is_file():
            return None
        try:
            with np.load(self.file, allow_pickle=False) as stored:
                arrays = dict(stored)
        except (OSError, ValueError) as error:
            raise InputError(f"'{self.file}' is damaged ({error}): remove it") from error
        z = arrays.pop("z")
        if len(z) != sum(lengths):
            return None
        descriptor = ShapeContextHistogram.from_arrays(arrays)
        return descriptor, np.split(z, np.cumsum(lengths)[:-1])

    def store(self, descriptor: ShapeContextHistogram, z: Sequence[Array]) -> None:
        """Keep them; the file gets its name only once it is whole."""
        try:
            self.file.parent.mkdir(parents=True, exist_ok=True)
            partial = self.file.with_name(f".{self.file.stem}.partial.npz")
            np.savez(partial, z=np.concatenate(z), **descriptor.to_arrays())
            partial.replace(self.file)
        except OSError as error:
            raise InputError(
                f"cannot write to '{self.file.parent}' ({error.strerror}): "
                "choose another dataset.keep"
            ) from error

"""NumPy archives from anywhere: nothing pickled is opened, and every error names its key."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from types import TracebackType

import numpy as np

from silpose.core.array_files import DAMAGE, first_line, wrong_size
from silpose.core.errors import InputError
from silpose.core.types import Array


class Archive:
    """An ``.npz`` file that is open for reading.

    Parameters
    ----------
    file : Path

    Raises
    ------
    InputError
        If it is no archive.
    """

    def __init__(self, file: Path) -> None:
        self.file = file
        try:
            stored = np.load(file, allow_pickle=False)
        except DAMAGE as error:
            raise InputError(
                f"{file}: is no .npz archive, or damaged ({first_line(error)}); download it again"
            ) from error
        if not isinstance(stored, np.lib.npyio.NpzFile):
            raise InputError(f"{file}: is no .npz archive but a single array; save it by np.savez")
        self._stored = stored

    def __enter__(self) -> Archive:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._stored.close()

    @property
    def keys(self) -> tuple[str, ...]:
        """Names of the arrays."""
        return tuple(self._stored)

    def first(self, keys: Sequence[str]) -> str | None:
        """Find the first of some keys that it has."""
        return next((key for key in keys if key in self._stored), None)

    def numbers(self, key: str) -> Array:
        """Read an array of real numbers, which may be written as text."""
        try:
            values = self._read(key)
        except DAMAGE as error:
            if isinstance(error, InputError):
                raise
            raise self.refuse(
                f"'{key}' cannot be read: it is pickled, which is not opened, or damaged; save it "
                "as an array of numbers"
            ) from error
        if values.dtype.kind in "SU":
            with suppress(ValueError):
                return values.astype(float)
        if not np.issubdtype(values.dtype, np.number) or np.iscomplexobj(values):
            raise self.refuse(f"'{key}' holds {values.dtype}, not numbers")
        return values.astype(float)

    def _read(self, key: str) -> Array:
        """Read an array after a look at its size, which its header may only claim."""
        archive = self._stored.zip
        assert archive is not None  # it is open
        member = next(m for m in archive.infolist() if m.filename in (key, f"{key}.npy"))
        with archive.open(member) as stream:
            if wrong := wrong_size(stream, member.file_size):
                raise self.refuse(f"'{key}' {wrong}; split it into shorter takes")
        return self._stored[key]

    def lacks(self, keys: Sequence[str], meaning: str) -> InputError:
        """Give the error that a key is missing."""
        wanted = " or ".join(f"'{key}'" for key in keys)
        return self.refuse(
            f"has no {wanted}, only {', '.join(self.keys) or 'nothing'}; add {meaning}"
        )

    def refuse(self, what: str) -> InputError:
        """Give an error that names the file."""
        return InputError(f"{self.file}: {what}")

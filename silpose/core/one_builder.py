"""Files in a cache that one process builds while others wait."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path

from filelock import FileLock


@contextmanager
def one_builder(file: Path) -> Iterator[bool]:
    """Let one process alone build a file of a cache; the others wait until it has, or has died.

    Parameters
    ----------
    file : Path
        Its folder is made where it is missing.

    Yields
    ------
    kept : bool
        False, with a warning, where nothing can be kept there.
    """
    lock = FileLock(file.with_suffix(".lock"))
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        lock.acquire()
    except (OSError, NotImplementedError) as error:  # the latter of file systems without locks
        _warn(file.parent, str(error.strerror) if isinstance(error, OSError) else "it has no locks")
        yield False
        return
    try:
        yield True
    finally:
        lock.release()


@cache
def _warn(folder: Path, reason: str) -> None:
    """Warn once: a run has several files in the same folder."""
    warnings.warn(
        f"cannot write to '{folder}' ({reason}): what is computed is not kept; choose another "
        "dataset.cache",
        stacklevel=5,
    )

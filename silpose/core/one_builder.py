"""Files in a cache that one process builds while others wait."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from filelock import FileLock

from silpose.core.errors import InputError


@contextmanager
def one_builder(file: Path) -> Iterator[None]:
    """Let one process alone build a file of a cache; the others wait until it has, or has died.

    Parameters
    ----------
    file : Path
        Its folder is made where it is missing.

    Raises
    ------
    InputError
        If the folder cannot be written to.
    """
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        lock = FileLock(file.with_suffix(".lock"))
        lock.acquire()
    except (OSError, NotImplementedError) as error:  # the latter of file systems without locks
        reason = error.strerror if isinstance(error, OSError) else "it has no locks"
        raise InputError(
            f"cannot write to '{file.parent}' ({reason}): choose another dataset.cache"
        ) from error
    try:
        yield
    finally:
        lock.release()

"""A folder for one run at a time."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from silpose.core.errors import InputError

try:
    import fcntl
except ModuleNotFoundError:  # Windows has no locks on folders: nothing is refused there
    fcntl = None  # type: ignore[assignment]


@contextmanager
def claimed(folder: Path) -> Iterator[None]:
    """Keep other runs out of a folder while the context lasts.

    The system holds the lock and frees it when the process ends, however that happens.

    Parameters
    ----------
    folder : Path

    Raises
    ------
    InputError
        If another run works in it.
    """
    if fcntl is None:
        yield
        return
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as error:
            raise InputError(
                f"another run is working in '{folder}': choose another recording.name"
            ) from error
        except OSError:
            pass  # a file system without locks
        yield
    finally:
        os.close(descriptor)

"""Files that get their name only once they are complete."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from silpose.core.errors import InputError


def partial(path: Path) -> Path:
    """Path of a file while it is being written: beside it, hidden, with the same ending."""
    return path.with_name(f".{path.stem}.partial{path.suffix}")


@contextmanager
def writing(path: Path) -> Iterator[Path]:
    """Write a file under a temporary name, and rename it at the end.

    Parameters
    ----------
    path : Path
        What was there before stays as it is if writing fails.

    Yields
    ------
    temporary : Path
        Where to write to.

    Raises
    ------
    InputError
        If nothing can be written there.
    """
    temporary = partial(path)
    try:
        temporary.touch()
    except OSError as error:
        raise InputError(
            f"cannot write '{path}' ({error.strerror}): choose another place"
        ) from error
    try:
        yield temporary
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise
    temporary.replace(path)

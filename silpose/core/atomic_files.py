"""Files that have their name only once they are whole."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from silpose.core.errors import InputError


def partial(path: Path) -> Path:
    """Where a file is written until it is whole: beside it, hidden, with the same ending."""
    return path.with_name(f".{path.stem}.partial{path.suffix}")


@contextmanager
def writing(path: Path) -> Iterator[Path]:
    """Give a path to write to; the file gets its name at the end, and nothing if that fails."""
    aside = partial(path)
    try:
        aside.touch()
    except OSError as error:
        raise InputError(
            f"cannot write '{path}' ({error.strerror}): choose another place"
        ) from error
    try:
        yield aside
    except BaseException:
        aside.unlink(missing_ok=True)
        raise
    aside.replace(path)

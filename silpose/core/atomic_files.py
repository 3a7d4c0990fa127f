"""Files that get their name only once they are complete, and lines that are whole."""

from __future__ import annotations

import errno
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from silpose.core.errors import InputError

_FULL = (errno.ENOSPC, errno.EFBIG, getattr(errno, "EDQUOT", errno.ENOSPC))
_NOT_WRITTEN = (*_FULL, errno.EIO, errno.EROFS)


def unfinished_pattern(path: Path) -> str:
    """Give the pattern of names that a file has while it is being written."""
    return f".{path.stem}.*partial{path.suffix}"


def unfinished(path: Path) -> list[Path]:
    """Find what is left of a file whose writing was cut off, the latest first."""
    found = path.parent.glob(unfinished_pattern(path))
    return sorted(found, key=lambda file: -file.stat().st_mtime)


@contextmanager
def writing(path: Path, check: Callable[[Path], object] | None = None) -> Iterator[Path]:
    """Write a file under a temporary name, and rename it once it is on the disk.

    Parameters
    ----------
    path : Path
        What was there before stays as it is if writing fails.
    check : callable, optional
        Reads the written file back before it gets its name, and raises what is wrong with it.

    Yields
    ------
    temporary : Path
        Where to write to: beside it, hidden, with the same ending, and of this process alone.

    Raises
    ------
    InputError
        If nothing can be written there, or not all of it.
    """
    temporary = path.with_name(f".{path.stem}.{os.getpid()}.partial{path.suffix}")
    try:
        temporary.touch()
    except OSError as error:
        raise not_written(path, error) from error
    try:
        yield temporary
        _to_disk(temporary)
        if check is not None:
            check(temporary)
        temporary.replace(path)
    except BaseException as error:
        temporary.unlink(missing_ok=True)
        # Some writers, such as Pillow's, give an error without a number when the disk is full.
        if type(error) is OSError and error.errno in (None, *_NOT_WRITTEN):
            raise not_written(path, error) from error
        raise


def append_line(path: Path, line: str) -> None:
    """Append a line to a file, whole or not at all.

    Parameters
    ----------
    path : Path
        Of lines that are whole; it is made where it is missing.
    line : str
        Ends in a line feed.

    Raises
    ------
    InputError
        If the line cannot be written; the file is as it was then.
    """
    try:
        with path.open("ab", buffering=0) as file:
            before, content = file.seek(0, os.SEEK_END), line.encode()
            try:
                if file.write(content) != len(content):  # the disk took only a part
                    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
            except OSError:
                file.truncate(before)
                raise
    except OSError as error:
        raise not_written(path, error) from error


def not_written(path: Path, error: OSError) -> InputError:
    """Give the error that a file could not be written, with what to do."""
    remedy = "choose another place"
    if error.errno in _FULL:
        remedy = f"free some space, or {remedy}"
    return InputError(f"cannot write '{path}' ({error.strerror or error}): {remedy}")


def _to_disk(path: Path) -> None:
    """Wait until a file is on the disk: some file systems say only then that they are full."""
    with path.open("rb+") as file:
        os.fsync(file.fileno())

"""Whether enough files can be opened: a run needs several at once, and its last files most."""

from __future__ import annotations

import os

from silpose.core.errors import InputError

_NEEDED = 32  # of a run with its workers and its recording


def check_open_files() -> None:
    """Refuse to begin where a run's end could not be written.

    Raises
    ------
    InputError
        If this process may open too few further files.
    """
    opened: list[int] = []
    try:
        for _ in range(_NEEDED):
            opened.append(os.open(os.devnull, os.O_RDONLY))
    except OSError as error:
        raise InputError(
            f"only {len(opened)} more files can be opened, and a run needs {_NEEDED}: raise the "
            "limit by 'ulimit -n 4096'"
        ) from error
    finally:
        for each in opened:
            os.close(each)

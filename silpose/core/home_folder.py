"""Paths that begin with ``~``."""

from __future__ import annotations

from pathlib import Path


def expanded(path: str | Path) -> Path:
    """Put the home folder in the place of a leading ``~``, as a shell does.

    Parameters
    ----------
    path : path

    Returns
    -------
    path : Path
        As it was where there is no such user, or nothing tells where the home folder is.
    """
    try:
        return Path(path).expanduser()
    except RuntimeError:
        return Path(path)

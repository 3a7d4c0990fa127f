"""Paths and commands as they can be typed in this terminal."""

from __future__ import annotations

import os
import shlex
import shutil
import sys
from pathlib import Path


def rerun_command() -> str:
    """Name the viewer so that it can be typed here: it may live in an environment of its own."""
    beside = Path(sys.executable).with_name("rerun")
    if shutil.which("rerun") or not beside.exists():
        return "rerun"
    return pasted(beside)


def pasted(path: Path) -> str:
    """Shorten a path, and quote it if a shell needs that."""
    return shlex.quote(shorten_path(path))


def shorten_path(path: Path) -> str:
    """Shorten a path that lies below the working folder."""
    full = os.path.abspath(path)  # not resolved: a virtual environment's links must stay
    below = os.path.relpath(full)
    return full if below.startswith("..") else below

"""A recording inside a notebook."""

from __future__ import annotations

import os
from contextlib import redirect_stdout
from io import StringIO
from pathlib import Path
from typing import Any

from silpose.core.errors import InputError


def show(recording: str | Path, height: int = 720) -> Any:
    """Show a recording in the viewer, embedded below the cell.

    Parameters
    ----------
    recording : path
        An ``.rrd`` file.
    height : int, default=720
        Pixels; the width is the cell's.

    Returns
    -------
    viewer : rerun_notebook.Viewer

    Raises
    ------
    InputError
        If there is no such recording, or the viewer for notebooks is not installed.
    """
    path = Path(recording)
    if not path.is_file():
        raise InputError(f"there is no recording '{path}'")
    # Read when rerun_notebook is imported. Its default fetches the viewer from the web, and
    # "inline" adds 23 MB to the saved notebook.
    os.environ.setdefault("RERUN_NOTEBOOK_ASSET", "serve-local")
    try:
        with redirect_stdout(StringIO()):  # three lines on where the viewer comes from
            from rerun_notebook import Viewer
    except ModuleNotFoundError as error:
        raise InputError(
            "the viewer for notebooks is not installed: pip install 'silpose[notebook]'"
        ) from error
    viewer = Viewer(width="auto", height=height)
    viewer.send_rrd(path.read_bytes())
    return viewer

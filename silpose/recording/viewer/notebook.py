"""A recording inside a notebook: the viewer, and a picture where no viewer can run."""

from __future__ import annotations

import base64
import os
from contextlib import redirect_stdout, suppress
from io import StringIO
from pathlib import Path
from typing import Any

from silpose.core.errors import InputError
from silpose.recording.plain_frames import PlainFrames

_STILL = """
<style>.jp-OutputArea-child:has(.silpose-still):has(+ .jp-OutputArea-child canvas)
{{ display: none; }}</style>
<img class="silpose-still" style="max-width: 100%" alt="Frames of the recording"
     src="data:image/png;base64,{}">
"""  # it stands for the viewer until that is there, and in a notebook that is only read


def show(recording: str | Path, height: int = 720) -> Any:
    """Show a recording in the viewer, embedded below the cell.

    Where no viewer can run, as in a saved notebook or a page made of one, frames of the
    recording are shown as a picture.

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

    See Also
    --------
    silpose.watch : Records what a model makes of a take, and shows it.
    """
    path = Path(recording)
    if not path.is_file():
        raise InputError(f"there is no recording '{path}'")
    viewer = _viewer_class()(width="auto", height=height)
    viewer.still = _still(path)
    viewer.send_rrd(path.read_bytes())
    return viewer


def _viewer_class() -> Any:
    """Import the viewer for notebooks, and have it show a picture until it is there."""
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
    from IPython.display import display

    class ViewerAfterPicture(Viewer):  # type: ignore[misc]
        """The viewer, and the picture in its place where it cannot run."""

        still: dict[str, str]

        def _ipython_display_(self) -> None:
            if self.still:
                display(self.still, raw=True)
            data, metadata = self._repr_mimebundle_()
            display(data, metadata=metadata, raw=True)

    return ViewerAfterPicture


def _still(recording: Path) -> dict[str, str]:
    """Frames of a recording as a picture, by MIME type; none of one without masks or poses."""
    with suppress(InputError):
        png = base64.b64encode(PlainFrames.read(recording).still()).decode()
        return {"image/png": png, "text/html": _STILL.format(png)}
    return {}

"""Pictures of a recording as the viewer draws it, without a screen."""

from __future__ import annotations

import os
import subprocess
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray
from rerun.experimental import ViewerClient

from silpose.core.atomic_files import writing
from silpose.core.errors import InputError
from silpose.recording.read import reader
from silpose.recording.viewer.process import HOST, free_port, start

_DRAWN = 0.5  # seconds until a first picture is complete
_ENDED = 1.0  # seconds that a viewer that fails takes to end
_PATIENCE = 120.0  # seconds until a viewer must have drawn, on a machine that is busy
_DRIVER = "it needs a Vulkan driver (Debian: mesa-vulkan-drivers)"


def picture(
    recording: str | Path, frame: int, path: str | Path, view: str | None = None, width: int = 1600
) -> None:
    """Write a picture of the viewer at one frame, as PNG.

    Parameters
    ----------
    recording : path
        An ``.rrd`` file.
    frame : int
    path : path
        The PNG.
    view : str, optional
        Beginning of the title of one view; by default the whole window.
    width : int, default=1600
        Pixels.

    Raises
    ------
    InputError
        If the recording cannot be read, no view has that title, or there is no Vulkan driver.

    See Also
    --------
    film : Several frames as GIF or MP4.
    """
    with writing(Path(path)) as aside, _shots(recording, view, width) as shoot:
        aside.write_bytes(shoot(frame))


def film(
    recording: str | Path,
    frames: Sequence[int],
    path: str | Path,
    view: str | None = None,
    width: int = 900,
    frames_per_second: float = 15.0,
) -> None:
    """Write a film of several frames, as an animated GIF or as MP4.

    Parameters
    ----------
    recording : path
    frames : sequence of int
    path : path
        Ends in ``.gif`` or ``.mp4``.
    view : str, optional
        Beginning of the title of one view; by default the whole window.
    width : int, default=900
        Pixels.
    frames_per_second : float, default=15

    Raises
    ------
    InputError
        As `picture`, and if there is no frame or the path has another ending.
    """
    path, frames = Path(path), list(frames)
    if not frames:
        raise InputError("a film needs at least one frame")
    if path.suffix not in (".gif", ".mp4"):
        raise InputError(f"'{path}' must end in .gif or .mp4")
    write = _write_mp4 if path.suffix == ".mp4" else _write_gif
    with writing(path) as aside:
        with _shots(recording, view, width) as shoot:
            images = [_decoded(shoot(frame)) for frame in frames]
        write(aside, images, frames_per_second)


def _decoded(png: bytes) -> NDArray[np.uint8]:
    return np.asarray(cv2.imdecode(np.frombuffer(png, np.uint8), cv2.IMREAD_COLOR), np.uint8)


def _write_mp4(path: Path, images: Sequence[NDArray[Any]], frames_per_second: float) -> None:
    height, width = images[0].shape[:2]
    fourcc = cv2.VideoWriter.fourcc(*"mp4v")
    writer = cv2.VideoWriter(str(path), fourcc, frames_per_second, (width, height))
    for image in images:
        writer.write(image)
    writer.release()
    written = cv2.VideoCapture(str(path))  # OpenCV says nothing of a write that failed
    count = int(written.get(cv2.CAP_PROP_FRAME_COUNT))
    written.release()
    if count != len(images):
        raise InputError(f"only {count} of {len(images)} frames could be written: free some space")


def _write_gif(path: Path, images: Sequence[NDArray[Any]], frames_per_second: float) -> None:
    from PIL import Image

    first, *others = (Image.fromarray(image[..., ::-1]) for image in images)
    duration = 1000 / frames_per_second
    first.save(path, save_all=True, append_images=others, duration=duration, loop=0)


@contextmanager
def opened(recording: str | Path) -> Iterator[ViewerClient]:
    """Open a recording in a viewer without a window, while the context lasts."""
    reader(recording)  # raises what is wrong with it
    os.environ.setdefault("XDG_RUNTIME_DIR", tempfile.gettempdir())
    port = free_port()
    try:
        # Without --expect-data-soon a note that the viewer listens covers the views.
        process = start("--headless", "--expect-data-soon", port=port, remedy="try again")
    except InputError as error:
        raise InputError(f"{error}; {_DRIVER}") from error
    try:
        viewer = ViewerClient(f"rerun+http://{HOST}:{port}/proxy")
        _load(viewer, Path(recording), process)
        time.sleep(_DRAWN)
        yield viewer
    finally:
        process.terminate()
        process.wait()


def _load(viewer: ViewerClient, recording: Path, process: subprocess.Popen[bytes]) -> None:
    """Wait until a viewer has drawn a recording; without a driver it ends once it should draw."""
    deadline = time.monotonic() + _PATIENCE
    while True:
        try:
            viewer.open(str(recording.absolute()))
            viewer.take_screenshot()  # waits until everything is loaded
            return
        except (OSError, RuntimeError) as error:
            with suppress(subprocess.TimeoutExpired):
                process.wait(_ENDED)
            if process.returncode is not None:
                raise InputError(f"Rerun cannot draw here: {_DRIVER}") from error
            if time.monotonic() > deadline:
                raise InputError(
                    f"Rerun does not draw within {_PATIENCE:.0f} seconds: try again when this "
                    "machine is less busy"
                ) from error


@contextmanager
def _shots(recording: str | Path, view: str | None, width: int) -> Iterator[Any]:
    """Open a viewer and yield a function from a frame to a PNG."""
    with opened(recording) as viewer:
        options: dict[str, Any] = {"max_size": width}
        if view is not None:
            options["view_id"] = _view(viewer.get_state().views, view)

        timed = any("frame" in chunk.timeline_names for chunk in reader(recording).stream())

        def shoot(frame: int) -> bytes:
            if timed:
                viewer.set_time("frame", sequence=frame, play_state="paused")
            return bytes(viewer.take_screenshot(**options))

        yield shoot


def _view(views: Any, title: str) -> Any:
    for view in views:
        if view.name and view.name.startswith(title):
            return view.view_id
    names = ", ".join(f"'{view.name}'" for view in views if view.name)
    raise InputError(f"no view's title begins with '{title}'; there are {names}")

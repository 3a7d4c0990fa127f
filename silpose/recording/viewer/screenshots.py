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
from silpose.recording.plain_frames import PlainFrames
from silpose.recording.read import frames_of, reader
from silpose.recording.viewer.process import HOST, free_port, start

_DRAWN = 0.5  # seconds until a first picture is complete
_NOTED = 5.0  # seconds for which a note that the viewer listens covers the window's top right
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
        If the recording cannot be read, it has no such frame, no view has that title, or there is
        no Vulkan driver.

    See Also
    --------
    film : Several frames as GIF or MP4.
    """
    _check_frames(recording, [frame])
    with writing(Path(path)) as aside, _shots(recording, view, width) as shoot:
        aside.write_bytes(shoot(frame))


def film(
    recording: str | Path,
    frames: Sequence[int],
    path: str | Path,
    view: str | None = None,
    width: int = 900,
    frames_per_second: float = 15.0,
    plain: bool = False,
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
    plain : bool, default=False
        Whether to draw mask, pose on the mask, and pose in 3D side by side instead of the viewer;
        this needs no driver.

    Raises
    ------
    InputError
        As `picture`, and if there is no frame, the path has another ending, or a view is asked of
        a plain film.
    """
    path, frames = Path(path), list(frames)
    if not frames:
        raise InputError("a film needs at least one frame")
    if path.suffix not in (".gif", ".mp4"):
        raise InputError(f"'{path}' must end in .gif or .mp4")
    if plain and view is not None:
        raise InputError("a plain film has no views: leave out either")
    _check_frames(recording, frames)
    write = _write_mp4 if path.suffix == ".mp4" else _write_gif
    with writing(path) as aside:
        if plain:
            images = PlainFrames.read(recording).film(frames, width)
        else:
            with _shots(recording, view, width) as shoot:
                images = [_decoded(shoot(frame)) for frame in frames]
        write(aside, images, frames_per_second)


def _check_frames(recording: str | Path, frames: Sequence[int]) -> None:
    """Refuse frames that a recording does not have; without any it looks as at its frame 0."""
    there = frames_of(recording) or range(1)
    if missing := [frame for frame in frames if frame not in there]:
        has = f"they are {there[0]} to {there[-1]}" if len(there) > 1 else f"only {there[0]}"
        raise InputError(f"'{recording}' has no frame {missing[0]}: {has}")


def _decoded(png: bytes) -> NDArray[np.uint8]:
    """Red, green and blue of a PNG, shape (H, W, 3)."""
    image = cv2.imdecode(np.frombuffer(png, np.uint8), cv2.IMREAD_COLOR)
    return np.ascontiguousarray(np.asarray(image, np.uint8)[..., ::-1])


def _write_mp4(path: Path, images: Sequence[NDArray[Any]], frames_per_second: float) -> None:
    height, width = images[0].shape[:2]
    fourcc = cv2.VideoWriter.fourcc(*"mp4v")
    writer = cv2.VideoWriter(str(path), fourcc, frames_per_second, (width, height))
    for image in images:
        writer.write(cv2.cvtColor(image, cv2.COLOR_RGB2BGR))
    writer.release()
    written = cv2.VideoCapture(str(path))  # OpenCV says nothing of a write that failed
    count = int(written.get(cv2.CAP_PROP_FRAME_COUNT))
    written.release()
    if count != len(images):
        raise InputError(f"only {count} of {len(images)} frames could be written: free some space")


def _write_gif(path: Path, images: Sequence[NDArray[Any]], frames_per_second: float) -> None:
    from PIL import Image

    first, *others = map(Image.fromarray, images)
    ends = np.rint(100 / frames_per_second * np.arange(len(images) + 1))  # a GIF's clock ticks so
    durations = (10 * np.diff(ends)).astype(int).tolist()
    first.save(path, save_all=True, append_images=others, duration=durations, loop=0)


@contextmanager
def opened(recording: str | Path) -> Iterator[ViewerClient]:
    """Open a recording in a viewer without a window, while the context lasts."""
    reader(recording)  # raises what is wrong with it
    os.environ.setdefault("XDG_RUNTIME_DIR", tempfile.gettempdir())
    port = free_port()
    try:
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
                raise _too_slow() from error


def _too_slow() -> InputError:
    return InputError(
        f"Rerun does not draw within {_PATIENCE:.0f} seconds: try again when this machine is less "
        "busy"
    )


@contextmanager
def _shots(recording: str | Path, view: str | None, width: int) -> Iterator[Any]:
    """Open a viewer and yield a function from a frame to a PNG."""
    with opened(recording) as viewer:
        options: dict[str, Any] = {"max_size": width}
        if view is not None:
            options["view_id"] = _view(viewer.get_state().views, view)

        timed = bool(frames_of(recording))

        def shoot(frame: int) -> bytes:
            deadline = time.monotonic() + _PATIENCE
            while True:
                try:
                    if timed:
                        viewer.set_time("frame", sequence=frame, play_state="paused")
                    return bytes(viewer.take_screenshot(**options))
                except TimeoutError as error:
                    if time.monotonic() > deadline:
                        raise _too_slow() from error

        if view is None:
            time.sleep(_NOTED)
            shoot(0)  # the first one after may still have the note
        yield shoot


def _view(views: Any, title: str) -> Any:
    for view in views:
        if view.name and view.name.startswith(title):
            return view.view_id
    names = ", ".join(f"'{view.name}'" for view in views if view.name)
    raise InputError(f"no view's title begins with '{title}'; there are {names}")

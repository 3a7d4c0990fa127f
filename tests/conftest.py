"""Small synthetic fixtures, and the real motion capture for those who have it."""

import os
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # the tests themselves run side by side

import cv2
import hypothesis
import pytest
from synthetic import motion

import silpose
from silpose.dataset import render_take
from silpose.silhouette import Body, Camera

os.environ.setdefault("RERUN_STRICT", "1")  # a wrong call is an error, not a warning

# A busy machine is no failure: tests that must be quick measure their own processor time.
hypothesis.settings.register_profile("usual", deadline=None)
hypothesis.settings.load_profile("usual")
hypothesis.settings.register_profile("long", max_examples=10_000, deadline=None)

PROJECT = Path(__file__).parents[1]
_COMPILES = Path("tests/fitting/test_stream.py")  # all of the fits, for a minute


def pytest_collection_modifyitems(items):
    """Put first what others wait for: what is compiled meanwhile is not compiled twice.

    Files of whole runs, beside the rooms, come in the middle, so that workers end together.
    """

    def place(item):
        file = item.path.relative_to(PROJECT)
        return file != _COMPILES, "evaluation" if len(file.parts) == 2 else file.parts[1]

    items.sort(key=place)


@pytest.fixture(scope="session")
def body():
    return Body("convex", level=2)


@pytest.fixture(scope="session")
def camera():
    return Camera(width=96, height=96)


@pytest.fixture(scope="session")
def sequence(body, camera):
    """40 frames of a small person, masks 96 x 96."""
    return render_take(motion("swinging", 40), body, camera)


FAST = (
    "motion.seconds=3",
    "motion.test_seconds=3",
    "silhouette.camera.width=96",
    "silhouette.camera.height=96",
    "descriptor.codebook_size=40",
    "regression.basis.width=[2]",
    "regression.ridge.damping=[0.1]",
    "methods=[ridge,rvm_20]",
    "show=rvm_20",
)


@pytest.fixture(scope="session")
def fast():
    """Settings for a whole run in a few seconds."""
    return FAST


@pytest.fixture(scope="session")
def finished(tmp_path_factory):
    """A finished run of the whole experiment, a few seconds of motion in small images."""
    root = tmp_path_factory.mktemp("recordings")
    return silpose.run_experiment([*FAST, f"recording.root={root}", "recording.name=small"])


@pytest.fixture(scope="session")
def mask_folder(tmp_path_factory, sequence):
    """A folder of 12 masks of a person, the sixth of them blank."""
    folder = tmp_path_factory.mktemp("masks")
    for frame, mask in enumerate(sequence.masks[:12]):
        cv2.imwrite(str(folder / f"{frame}.png"), 255 * mask * (frame != 5))
    return folder


@pytest.fixture(scope="session")
def shared_mocap():
    """The folder of real motion capture; CI has it, and fails where it is missing."""
    folder = PROJECT.parent / "shared" / "mocap"
    if not folder.is_dir():
        if os.environ.get("CI"):
            pytest.fail("the real motion capture is missing in CI")
        pytest.skip("the real motion capture is not on this machine")
    return folder


@pytest.fixture
def read_only(tmp_path, monkeypatch):
    """A folder that nobody can write to, not even the superuser."""
    folder = tmp_path / "read_only"
    folder.mkdir()

    def refusing(method):
        def call(path, *given, **more):
            if path.is_relative_to(folder):
                raise PermissionError(13, "Permission denied", str(path))
            return method(path, *given, **more)

        return call

    for name in ("touch", "mkdir"):
        monkeypatch.setattr(Path, name, refusing(getattr(Path, name)))
    return folder

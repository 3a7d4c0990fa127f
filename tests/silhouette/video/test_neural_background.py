"""MediaPipe is not here: a network that takes what is bright for a person stands for it."""

import sys

import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette.video import VideoMasks
from silpose.silhouette.video.neural_background import NeuralBackground

NETWORK = """
from types import SimpleNamespace

class SelfieSegmentation:
    def __init__(self, model_selection):
        print("a library that prints")
    def process(self, picture):
        if picture.max() == 0:
            raise MemoryError
        return SimpleNamespace(segmentation_mask=picture[..., 0] / 255)
"""
PYTHON = """#!{python}
import runpy, sys
sys.path.insert(0, "{packages}")
assert sys.argv.pop(0) and sys.argv.pop(0) == "-I"
runpy.run_path(sys.argv[0], run_name="__main__")
"""


@pytest.fixture
def environment(tmp_path):
    """A folder like that of a Python environment with MediaPipe."""
    solutions = tmp_path / "packages" / "mediapipe" / "python" / "solutions"
    solutions.mkdir(parents=True)
    (solutions / "selfie_segmentation.py").write_text(NETWORK)
    python = tmp_path / "bin" / "python"
    python.parent.mkdir()
    python.write_text(PYTHON.format(python=sys.executable, packages=tmp_path / "packages"))
    python.chmod(0o755)
    return str(tmp_path)


def test_what_the_network_sees_is_the_mask(environment):
    background = NeuralBackground(environment)
    for height, width in ((30, 40), (60, 20)):
        picture = np.full((height, width, 3), 10, np.uint8)
        picture[5:20, 4:9] = 200
        found = background.step(picture)
        assert not found.switched
        assert (found.weak == (picture[..., 0] == 200)).all()
        assert (found.strong == found.weak).all()
    with pytest.raises(InputError, match="MediaPipe has ended by itself"):
        background.step(np.zeros((9, 9, 3), np.uint8))


def test_it_finds_the_person_of_a_film(environment, film, truth):
    video = VideoMasks(film, background="selfie", environment=environment, last=3)
    for frame, mask in zip(video, truth, strict=False):
        assert (frame.mask & mask).sum() > 0.8 * mask.sum()


def test_without_it_one_sentence_names_it(tmp_path, film):
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin" / "python").symlink_to(sys.executable)
    for environment in (str(tmp_path), str(tmp_path / "nowhere")):
        with pytest.raises(InputError, match="venv selfie && selfie/bin/pip install mediapipe==0"):
            next(iter(VideoMasks(film, background="selfie", environment=environment)))

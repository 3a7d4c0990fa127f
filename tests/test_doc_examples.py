"""The Python of the documentation, run in the order in which a reader meets it on a page."""

import re
from pathlib import Path

import cv2
import matplotlib.pyplot as plt
import numpy as np
import pytest
from synthetic import motion
from video_films import figure, noisy, paint, wall

import silpose
from silpose.core.pose_space import ANGLES
from silpose.dataset import render_take
from silpose.silhouette import Body, Camera

PROJECT = Path(__file__).parents[1]
BLOCK = re.compile(r"```python\n(.*?)```", re.DOTALL)
PAGES = [
    page
    for page in (PROJECT / "README.md", *sorted((PROJECT / "docs").rglob("*.md")))
    if BLOCK.search(page.read_text())
]

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def folder(tmp_path_factory, fast):
    """A folder as a reader has it: two runs, masks, and a film."""
    folder = tmp_path_factory.mktemp("reader")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        small = [setting for setting in fast if not setting.startswith(("methods", "show"))]
        for experiment in ("single_image", "tracking"):
            silpose.run_experiment([f"experiment={experiment}", "fitting.enabled=true", *small])
    take = render_take(motion("swinging", 45), Body(level=2), Camera(width=96, height=96))
    (folder / "MASKS").mkdir()
    (folder / "FILM").mkdir()
    rng, scene = np.random.default_rng(0), wall()
    for frame, mask in enumerate(take.masks):
        cv2.imwrite(str(folder / "MASKS" / f"{frame:03}.png"), 255 * mask)
        picture = noisy(paint(scene, figure(take.masks, frame, step=3)), rng)
        cv2.imwrite(str(folder / "FILM" / f"{frame:03}.png"), picture)
    (folder / "FOLDER").mkdir()
    return folder


@pytest.fixture
def names(folder):
    """What a page takes for granted."""
    rng = np.random.default_rng(1)
    z = rng.dirichlet(np.ones(12), 90)
    x = ANGLES.from_angles(60 * z @ rng.normal(size=(12, 54)))
    take = render_take(motion("swinging", 20), Body(level=2), Camera(width=96, height=96))
    return {
        "silpose": silpose,
        "np": np,
        "X": z,
        "Y": x,
        "z": z[:30],
        "takes": [(z[:45], x[:45]), (z[45:], x[45:])],
        "masks": list(take.masks),
        "model": silpose.load(folder / "recordings" / "single_image" / "001"),
        "__name__": "__main__",
    }


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
@pytest.mark.filterwarnings("ignore")  # the models are as small as a test's
def test_examples_run(page, folder, names, monkeypatch):
    monkeypatch.chdir(folder)
    for block in BLOCK.findall(page.read_text()):
        exec(compile(block, page.name, "exec"), names)
    plt.close("all")

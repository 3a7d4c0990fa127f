"""Make the pictures of the documentation: a film, the viewer, and each experiment's figure.

    python docs/pictures.py                       # all of them
    python docs/pictures.py silpose.gif tracking  # some

`docs/figures.md` then shows what there is. Experiments run with their default settings, in a folder
that is deleted afterwards. The viewer's picture needs a Vulkan driver.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path

from PIL import Image

import silpose
from silpose.experiments import EXPERIMENTS
from silpose.experiments.catalogue import CATALOGUE
from silpose.recording import FinishedRun, film, picture

DOCS = Path(__file__).parent
WIDTH, COLOURS = 1000, 64  # pixels and colours of a picture, so that it stays small
OF_OWN_DATA = {"masks", "motion_report", "predict", "training_data", "video"}  # these need data
SECONDS, RATE = 6, 15  # of the film
FRAME = 176  # of the viewer's picture


@cache
def run_of(experiment: str) -> FinishedRun:
    """Run an experiment once."""
    folder = tempfile.TemporaryDirectory()
    _folders.append(folder)
    return silpose.run_experiment([f"experiment={experiment}", f"recording.root={folder.name}"])


_folders: list[tempfile.TemporaryDirectory[str]] = []  # kept until the program ends


def make_film(path: Path) -> None:
    """Make a film of a tracked walker: mask, pose on the mask, pose in 3D."""
    recording = run_of("tracking").recording
    film(recording, range(SECONDS * RATE), path, frames_per_second=RATE, plain=True)


def make_viewer(path: Path) -> None:
    """Take a picture of the viewer with a recording of several hypotheses."""
    picture(run_of("hypotheses").recording, FRAME, path)
    _save_small(path, path)


def make_figure(path: Path) -> None:
    """Make the figure of the experiment that the path is named after."""
    _save_small(run_of(path.stem).folder / path.name, path)


def _save_small(source: Path, path: Path) -> None:
    image = Image.open(source).convert("RGB")
    image.thumbnail((WIDTH, 10 * WIDTH), Image.Resampling.LANCZOS)
    image.quantize(COLOURS, dither=Image.Dither.NONE).save(path, optimize=True)


PICTURES: dict[str, Callable[[Path], None]] = {
    "silpose.gif": make_film,
    "viewer.png": make_viewer,
} | {f"{name}.png": make_figure for name in EXPERIMENTS if name not in OF_OWN_DATA}


def write_index() -> None:
    """Write the page that shows the pictures, each with the question that it answers."""
    shown = [
        f"## `{name}`\n\n{entry.question}\n\n![{name}]({name}.png)\n"
        for name, entry in CATALOGUE.items()
        if (DOCS / f"{name}.png").exists()
    ]
    title = "# What the experiments show\n\nMade by `python docs/pictures.py`.\n"
    (DOCS / "figures.md").write_text("\n".join([title, *shown]), encoding="utf-8")


def main(names: Sequence[str]) -> None:
    """Make the pictures of these names, with or without their ending, or all."""
    for name, make in PICTURES.items():
        if not names or {name, Path(name).stem} & {*names}:
            make(DOCS / name)
            print(f"{name}: {(DOCS / name).stat().st_size / 1e3:.0f} kB", flush=True)
    write_index()


if __name__ == "__main__":
    main(sys.argv[1:])

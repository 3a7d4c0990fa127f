"""Whole experiments on a few seconds of motion in small images."""

import csv
import json

import cv2
import pytest
from rerun.chunk import RrdReader

from silpose.app.config import load
from silpose.app.main import run_experiment

SMALL = (
    "motion.seconds=3",
    "motion.test_seconds=3",
    "silhouette.camera.width=96",
    "silhouette.camera.height=96",
    "descriptor.codebook_size=40",
)


@pytest.fixture
def study(tmp_path):
    """Run an experiment; give its metrics, its rows and its folder."""

    def run(name, *overrides):
        root = f"recording.root={tmp_path}"
        small = SMALL if "motion=bvh" not in overrides else SMALL[2:]
        run_experiment(load([f"experiment={name}", *small, root, *overrides]))
        folder = tmp_path / name / "001"
        rows = []
        if (folder / "results.csv").exists():
            with (folder / "results.csv").open() as file:
                rows = list(csv.DictReader(file))
        assert cv2.imread(str(folder / f"{name}.png")).std() > 10
        assert len(list(RrdReader(folder / "run.rrd").stream())) > 5
        return json.loads((folder / "metrics.json").read_text())["metrics"], rows

    return run

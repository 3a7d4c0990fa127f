"""Finished runs that are only their files."""

import json

import pytest

from silpose.recording import load_run


@pytest.fixture
def finished_run(tmp_path):
    """A function that writes the files of a run, and reads it back."""

    def write(experiment, metrics, *, name="walkers", rows=""):
        folder = tmp_path / experiment / name
        folder.mkdir(parents=True)
        content = {
            "experiment": experiment, "dataset": "made up", "seed": 0, "seconds": {"all": 1.0},
            "metrics": metrics,
        }  # fmt: skip
        (folder / "metrics.json").write_text(json.dumps(content))
        (folder / "config.yaml").write_text("seed: 0\n")
        if rows:
            (folder / "results.csv").write_text(rows)
        return load_run(folder)

    return write

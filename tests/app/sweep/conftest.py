"""Sweeps of runs that take no time: each writes a small result."""

import sys

import pytest
from omegaconf import OmegaConf

from silpose.app.build import build
from silpose.app.config import plain
from silpose.app.main import main
from silpose.recording import Result, load_run, write_result


def quick_run(settings):
    """Finish a run whose headline is seed + slack; that of seed 13 fails."""
    given = plain(settings)
    seed = given["seed"]
    if seed == 13:
        raise ValueError("no luck")
    text = OmegaConf.to_yaml(settings, resolve=True)
    folder = build("recording", given["recording"], experiment=given["experiment"], settings=text)
    error = seed + given["regression"]["slack"]
    metrics = {"ridge": {"mean_angular_error_deg": error}}
    write_result(folder, Result("walker", metrics, headline=error), seed, {"fit": 0.25})
    return load_run(folder.folder)


@pytest.fixture
def ran():
    """Seeds of the quick runs that were really run, in order."""
    return []


@pytest.fixture
def sweep(tmp_path, monkeypatch, capfd, ran):
    """Sweep by the command in an empty folder; give exit status and output."""
    monkeypatch.chdir(tmp_path)

    def remember(settings):
        ran.append(settings.seed)
        return quick_run(settings)

    monkeypatch.setattr("silpose.app.run.run_experiment", remember)

    def command(*arguments):
        monkeypatch.setattr(sys, "argv", ["silpose", *arguments])
        try:
            main()
            status = 0
        except SystemExit as stop:
            status = stop.code
        return status, capfd.readouterr().out

    return command

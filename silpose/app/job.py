"""The job that Hydra runs: one experiment, or in a sweep one after the other."""

from __future__ import annotations

import sys

import hydra
from hydra.core.hydra_config import HydraConfig
from hydra.errors import HydraException
from hydra.types import RunMode
from omegaconf import DictConfig

from silpose.app.conf_folder import config_folder
from silpose.app.config import check_overrides, explain
from silpose.app.failures import sentence
from silpose.app.schema import register
from silpose.core.errors import InputError
from silpose.core.stages import stage


def run_job() -> None:
    """Compose the settings from the command line, and run what they name."""
    register()
    folder = str(config_folder())
    try:
        hydra.main(version_base="1.3", config_path=folder, config_name="config")(_job)()
    except HydraException as error:
        raise InputError(explain(error, sys.argv[1:])) from error


def _job(settings: DictConfig) -> float | None:
    """Run an experiment; the number is what a sweep minimises."""
    in_sweep = HydraConfig.get().mode == RunMode.MULTIRUN
    try:
        overrides = HydraConfig.get().overrides.task
        check_overrides(settings, overrides)
        if in_sweep:
            print(*overrides)
        with stage("loading"):
            from silpose.app.run import run_experiment  # heavy: only once the overrides are right
            from silpose.app.summary import summarise

        run = run_experiment(settings)
        summarise(run)
    except Exception as error:
        # Hydra would add lines of its own. In a sweep they say which job it was, and the other
        # jobs go on.
        if settings.debug or in_sweep:
            raise
        raise SystemExit(sentence(error)) from None
    return run.headline


def go_on_showing() -> None:
    """Serve what a run shows in the browser until Ctrl-C."""
    from silpose.recording.viewer import serving, wait

    for page in serving():
        print(f"Watch it:  {page}   (until Ctrl-C)", flush=True)
    wait()

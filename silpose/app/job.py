"""The job that Hydra runs: one experiment, or in a sweep many."""

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
from silpose.app.outputs import stop_quietly
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
    own = HydraConfig.get()
    if own.mode == RunMode.MULTIRUN:
        from silpose.app.sweep.engines import runs_alone
        from silpose.app.sweep.job import run_in_sweep

        return run_in_sweep(settings, own.overrides.task, runs_alone(own.launcher))
    try:
        check_overrides(settings, own.overrides.task)
        with stage("loading"):
            from silpose.app.run import run_experiment  # heavy: only once the overrides are right
            from silpose.app.summary import summarise

        run = run_experiment(settings)
        try:
            summarise(run)
        except BrokenPipeError:  # which Hydra would report
            stop_quietly()
    except Exception as error:
        if settings.debug:
            raise
        raise SystemExit(sentence(error)) from None  # to which Hydra adds no lines of its own
    return run.headline


def go_on_showing() -> None:
    """Serve what a run shows in the browser until Ctrl-C."""
    from silpose.recording.viewer import serving, wait

    for page in serving():
        print(f"Watch it:  {page}   (until Ctrl-C)", flush=True)
    wait()

"""The command ``silpose``: composes the settings and runs the experiment they name."""

from __future__ import annotations

import os
import sys
import warnings
from typing import TYPE_CHECKING

import hydra
from hydra.core.hydra_config import HydraConfig
from hydra.errors import HydraException
from hydra.types import RunMode
from omegaconf import DictConfig, OmegaConf

from silpose.app.commands import TOOLS, run_tool
from silpose.app.config import build, build_components, check_overrides, config_folder, explain
from silpose.core.errors import InputError

if TYPE_CHECKING:
    from silpose.recording.runs.finished_run import FinishedRun

_HOUSE = ("motion", "silhouette", "dataset", "descriptor", "regression", "tracking", "recording")


def main() -> None:
    """Run ``silpose`` from the command line; what goes wrong is one sentence."""
    os.environ["HYDRA_FULL_ERROR"] = "1"  # so that Hydra leaves its errors to us
    warnings.showwarning = lambda message, *_: print(f"silpose: {message}", file=sys.stderr)
    try:
        if sys.argv[1:2] and sys.argv[1] in TOOLS:
            run_tool(sys.argv[1:])
            return
        folder = str(config_folder())
        hydra.main(version_base="1.3", config_path=folder, config_name="config")(_job)()
        _go_on_showing()
    except Exception as error:
        if "debug=true" in sys.argv:
            raise
        raise SystemExit(_sentence(error)) from None


def _job(settings: DictConfig) -> None:
    from silpose.app.summary import summarise

    try:
        overrides = HydraConfig.get().overrides.task
        check_overrides(settings, overrides)
        if _in_sweep():
            print(*overrides)
        summarise(run_experiment(settings))
    except Exception as error:
        # Hydra would add lines of its own. In a sweep they say which job it was, and the other
        # jobs go on.
        if settings.debug or _in_sweep():
            raise
        raise SystemExit(_sentence(error)) from None


def _go_on_showing() -> None:
    """Serve what a run shows in the browser until Ctrl-C."""
    from silpose.recording.viewer.process import serving, wait

    for page in serving():
        print(f"Watch it:  {page}   (until Ctrl-C)", flush=True)
    wait()


def _in_sweep() -> bool:
    return HydraConfig.get().mode == RunMode.MULTIRUN


def _sentence(error: Exception) -> str:
    if isinstance(error, InputError):
        return f"silpose: {error}"
    if isinstance(error, HydraException):
        return f"silpose: {explain(error)}"
    kind = type(error).__name__
    return f"silpose: unexpected {kind}: {error} (debug=true shows where it comes from)"


def run_experiment(settings: DictConfig) -> FinishedRun:
    """Build the rooms, run the experiment in a folder of its own, and read back what came out."""
    # Heavy imports wait until there is something to do: --help answers at once.
    from silpose.experiments import EXPERIMENTS
    from silpose.recording.runs.finished_run import load_run
    from silpose.recording.runs.run_folder import Run

    rooms = build_components(settings)
    name = settings.experiment
    own = {
        str(k): v for k, v in settings.items() if k not in (*_HOUSE, "experiment", "seed", "debug")
    }
    text = OmegaConf.to_yaml(settings, resolve=True)
    run = build(Run.start, settings.recording, "recording", experiment=name, settings=text)
    try:
        build(EXPERIMENTS[name], own, "", rooms=rooms, run=run)
    except BaseException:
        run.abandon()
        raise
    return load_run(run.folder)


if __name__ == "__main__":
    main()

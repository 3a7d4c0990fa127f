"""The command ``silpose``: composes the settings and runs the experiment they name."""

from __future__ import annotations

import sys

import hydra
from hydra.core.hydra_config import HydraConfig
from omegaconf import DictConfig, OmegaConf

from silpose.config import build, check_overrides, config_folder, furnish
from silpose.errors import InputError

_HOUSE = ("motion", "silhouette", "dataset", "descriptor", "regression", "recording")


def main() -> None:
    """Run ``silpose`` from the command line."""
    try:
        folder = str(config_folder())
    except InputError as error:
        raise SystemExit(f"silpose: {error}") from None
    hydra.main(version_base="1.3", config_path=folder, config_name="config")(_job)()


def _job(settings: DictConfig) -> None:
    """Run one experiment; what goes wrong is one sentence, unless ``debug=true``."""
    try:
        check_overrides(settings, HydraConfig.get().overrides.task)
        run_experiment(settings)
    except Exception as error:
        if settings.debug:
            raise
        if isinstance(error, InputError):
            raise SystemExit(f"silpose: {error}") from None
        kind = type(error).__name__
        raise SystemExit(
            f"silpose: unexpected {kind}: {error} (debug=true shows where it comes from)"
        ) from None


def run_experiment(settings: DictConfig) -> None:
    """Build the rooms, run the experiment in a folder of its own, and say what came out."""
    # Heavy imports wait until there is something to do: --help answers at once.
    from silpose.experiments import EXPERIMENTS
    from silpose.run import Run, load_run
    from silpose.summary import summarise

    rooms = furnish(settings)
    name = settings.experiment
    own = {k: v for k, v in settings.items() if k not in (*_HOUSE, "experiment", "seed", "debug")}
    text = OmegaConf.to_yaml(settings, resolve=True)
    run = build(Run.start, settings.recording, "recording", experiment=name, settings=text)
    try:
        build(EXPERIMENTS[name], own, name, rooms=rooms, run=run)
    except BaseException:
        run.abandon()
        raise
    summarise(load_run(run.folder))


if __name__ == "__main__":
    sys.exit(main())

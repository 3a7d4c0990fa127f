"""The command ``silpose``: composes the settings and runs the experiment they name."""

from __future__ import annotations

import sys

import hydra
from hydra.core.hydra_config import HydraConfig
from omegaconf import DictConfig

from silpose.config import check_overrides, config_folder
from silpose.errors import InputError


def main() -> None:
    """Run ``silpose`` from the command line."""
    try:
        folder = str(config_folder())
    except InputError as error:
        raise SystemExit(f"silpose: {error}") from None
    hydra.main(version_base="1.3", config_path=folder, config_name="config")(_job)()


def _job(settings: DictConfig) -> None:
    try:
        check_overrides(settings, HydraConfig.get().overrides.task)
        from silpose.launch import launch  # heavy imports wait until there is something to do

        launch(settings)
    except Exception as error:
        if settings.debug:
            raise
        if isinstance(error, InputError):
            raise SystemExit(f"silpose: {error}") from None
        kind = type(error).__name__
        raise SystemExit(
            f"silpose: unexpected {kind}: {error} (debug=true shows where it comes from)"
        ) from None


if __name__ == "__main__":
    sys.exit(main())

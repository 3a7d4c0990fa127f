"""The command ``silpose``: settings are composed, an experiment is built and run, its result shown.

Settings come from ``conf/`` and the command line by way of Hydra, which only this package knows;
what they mean is read from the signatures of the classes and functions that they are for.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from silpose.core.lazy_exports import lazy_exports

if TYPE_CHECKING:
    from silpose.app.compose import build_components
    from silpose.app.config import load
    from silpose.app.run import run_experiment

__getattr__ = lazy_exports(
    __name__,
    {"compose": ("build_components",), "config": ("load",), "run": ("run_experiment",)},
)

__all__ = ["build_components", "load", "run_experiment"]

"""Experiments, one module and one function each: what the paper shows, and what it leaves open.

Each takes `Components`, which `silpose.app` builds from settings, and its own parameters, and
returns a `silpose.recording.Result`. Modules are imported when their experiments are asked for.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from importlib import import_module
from typing import TYPE_CHECKING

from silpose.core.lazy_exports import lazy_exports
from silpose.experiments.catalogue import CATALOGUE

if TYPE_CHECKING:
    from silpose.experiments.setup import Components, prepare, prepare_tracking
    from silpose.recording import Result


class _Experiments(Mapping[str, "Callable[..., Result]"]):
    """Experiments by name: module and function share it."""

    def __getitem__(self, name: str) -> Callable[..., Result]:
        if name not in CATALOGUE:
            raise KeyError(name)
        experiment: Callable[..., Result] = getattr(import_module(f"{__name__}.{name}"), name)
        return experiment

    def __iter__(self) -> Iterator[str]:
        return iter(CATALOGUE)

    def __len__(self) -> int:
        return len(CATALOGUE)


EXPERIMENTS: Mapping[str, Callable[..., Result]] = _Experiments()

__getattr__ = lazy_exports(__name__, {"setup": ("Components", "prepare", "prepare_tracking")})

__all__ = ["CATALOGUE", "EXPERIMENTS", "Components", "prepare", "prepare_tracking"]

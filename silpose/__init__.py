"""silpose: a person's 3D pose from silhouettes alone, by regression, watched step by step.

>>> import silpose
>>> model = silpose.load("recordings/single_image/001")  # doctest: +SKIP
>>> poses = model.predict("my_masks")  # doctest: +SKIP
>>> poses.joints, poses.heading, poses.heading_norm  # doctest: +SKIP
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from silpose.core.lazy_exports import lazy_exports

if TYPE_CHECKING:
    from silpose.app.run import run_experiment
    from silpose.core.errors import InputError
    from silpose.model import PoseModel, load
    from silpose.recording import load_poses, load_run, runs_table, show, watch

__getattr__ = lazy_exports(
    __name__,
    {
        "app.run": ("run_experiment",),
        "core.errors": ("InputError",),
        "model": ("PoseModel", "load"),
        "recording": ("load_poses", "load_run", "runs_table", "show", "watch"),
    },
)

__all__ = [
    "InputError",
    "PoseModel",
    "load",
    "load_poses",
    "load_run",
    "run_experiment",
    "runs_table",
    "show",
    "watch",
]


def __dir__() -> list[str]:
    return sorted(__all__)

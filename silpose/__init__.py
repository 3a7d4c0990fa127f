"""silpose: a person's 3D pose from silhouettes alone, by regression, watched step by step.

>>> import silpose
>>> model = silpose.load("recordings/single_image/001")  # doctest: +SKIP
>>> poses = model.predict("my_masks")  # doctest: +SKIP
>>> poses.joints, poses.heading, poses.heading_norm  # doctest: +SKIP
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from silpose.run import load_run, runs_table

if TYPE_CHECKING:
    from silpose.model import PoseModel


def load(path: str | Path) -> PoseModel:
    """Read a saved model: an ``.npz``, or the folder of the run that holds it."""
    from silpose.model import PoseModel

    return PoseModel.load(path)


__all__ = ["load", "load_run", "runs_table"]

"""silpose: a person's 3D pose from silhouettes alone, by regression, watched step by step.

>>> import silpose
>>> model = silpose.load("recordings/single_image/001")  # doctest: +SKIP
>>> poses = model.predict("my_masks")  # doctest: +SKIP
>>> poses.joints, poses.heading, poses.heading_norm  # doctest: +SKIP
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from silpose.recording.runs.finished_run import load_run, runs_table

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from silpose.model.pose_model import PoseModel


def load(path: str | Path) -> PoseModel:
    """Read a saved model: an ``.npz``, or the folder of the run that holds it."""
    from silpose.model.pose_model import PoseModel

    return PoseModel.load(path)


def load_poses(path: str | Path) -> dict[str, NDArray[np.float64]]:
    """Read pose vectors (F, D) back from a recording: an ``.rrd``, or the folder of its run.

    By name: ``true`` where the truth is known; ``estimated``, or each method that was drawn.
    """
    from silpose.recording import read_poses

    path = Path(path)
    return read_poses(path / "run.rrd" if path.is_dir() else path)


__all__ = ["load", "load_poses", "load_run", "runs_table"]

"""Joint positions as TRC, which OpenSim and Pose2Sim read."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from silpose.core.types import Array


def write_trc(
    file: Path,
    title: str,
    joints: Array,
    names: Sequence[str],
    time: Array,
    frames_per_second: float,
) -> None:
    """Write joint positions as markers, in metres, +Y up.

    Parameters
    ----------
    file : Path
    title : str
        Name that the file gives itself.
    joints : ndarray, shape (F, J, 3)
        A marker of NaN is left empty, as both programs expect.
    names : sequence of str
        Of the J joints.
    time : ndarray, shape (F,)
        Seconds.
    frames_per_second : float
    """
    frames, rate = len(joints), f"{frames_per_second:.6g}"
    titles: list[object] = [
        "DataRate", "CameraRate", "NumFrames", "NumMarkers", "Units", "OrigDataRate",
        "OrigDataStartFrame", "OrigNumFrames",
    ]  # fmt: skip
    values: list[object] = [rate, rate, frames, len(names), "m", rate, 1, frames]
    axes = [f"{axis}{j}" for j in range(1, len(names) + 1) for axis in "XYZ"]
    lines: list[list[object]] = [
        ["PathFileType", 4, "(X/Y/Z)", title],
        titles,
        values,
        ["Frame#", "Time", *(cell for name in names for cell in (name, "", ""))],
        ["", "", *axes],
    ]
    for number, (seconds, row) in enumerate(zip(time, joints, strict=True), start=1):
        places = [f"{value:.6f}" if np.isfinite(value) else "" for value in row.ravel()]
        lines.append([number, f"{seconds:.6f}", *places])
    with file.open("w", encoding="utf-8", newline="\r\n") as text:
        text.writelines("\t".join(map(str, line)) + "\n" for line in lines)

"""Salvage of a recording that was cut off because its run crashed or was killed."""

from __future__ import annotations

import subprocess
from pathlib import Path

from silpose.core.atomic_files import unfinished, writing
from silpose.core.errors import InputError
from silpose.recording.read import reader
from silpose.recording.viewer.process import program

SALVAGED = "salvaged.rrd"  # never run.rrd: the run was not finished


def repair(broken: str | Path) -> Path:
    """Write what can still be read of a recording to a new, complete one.

    Parameters
    ----------
    broken : path
        A recording, or the folder of a run that was cut off.

    Returns
    -------
    salvaged : Path
        ``salvaged.rrd`` beside it. The broken file stays as it is.

    Raises
    ------
    InputError
        If there is no recording, or nothing in it can be read.
    """
    broken = Path(broken)
    if broken.is_dir():
        inside = broken / "run.rrd"
        found = [*unfinished(inside), *([inside] if inside.is_file() else [])]
        if not found:
            raise InputError(f"'{broken}' holds no recording to salvage")
        broken = found[0]
    if not broken.is_file():
        raise InputError(f"there is no recording '{broken}'")
    salvaged = broken.with_name(SALVAGED)
    with writing(salvaged) as path:
        command = [program(), "rrd", "optimize", str(broken), "-o", str(path)]
        subprocess.run(command, capture_output=True)
        try:
            reader(path)
        except InputError as error:
            raise InputError(
                f"nothing can be salvaged from '{broken}': run the experiment again"
            ) from error
    return salvaged

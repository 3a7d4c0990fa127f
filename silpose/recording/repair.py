"""Salvaging a recording that a crash or a kill has cut off."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from silpose.errors import InputError
from silpose.recording.read import reader

SALVAGED = "salvaged.rrd"  # never run.rrd: the run was not finished


def repair(broken: str | Path) -> Path:
    """Write what can still be read of a recording to a whole one.

    Parameters
    ----------
    broken : path
        A recording, or the folder of a run that was cut off.

    Returns
    -------
    salvaged : Path
        ``salvaged.rrd`` beside it. The broken file stays as it is.
    """
    broken = Path(broken)
    if broken.is_dir():
        inside = [broken / name for name in (".run.rrd.partial", "run.rrd")]
        found = [path for path in inside if path.is_file()]
        if not found:
            raise InputError(f"'{broken}' holds no recording to salvage")
        broken = found[0]
    if not broken.is_file():
        raise InputError(f"there is no recording '{broken}'")
    salvaged = broken.with_name(SALVAGED)
    partial = salvaged.with_name(f".{SALVAGED}.partial.rrd")
    rerun = Path(sys.executable).with_name("rerun")
    command = [str(rerun if rerun.exists() else "rerun"), "rrd", "optimize"]
    subprocess.run([*command, str(broken), "-o", str(partial)], capture_output=True)
    try:
        reader(partial)
    except InputError as error:
        partial.unlink(missing_ok=True)
        raise InputError(
            f"nothing can be salvaged from '{broken}': run the experiment again"
        ) from error
    partial.replace(salvaged)
    return salvaged

"""Any motion capture file, told by its ending."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from silpose.core.errors import InputError
from silpose.motion.capture.formats.amass import read_amass
from silpose.motion.capture.formats.asf_amc import read_asf_amc
from silpose.motion.capture.formats.bvh import read_bvh
from silpose.motion.capture.raw_motion import RawMotion

_READERS: dict[str, Callable[[Path, float | None], RawMotion]] = {
    "bvh": read_bvh,
    "amc": read_asf_amc,
    "npz": read_amass,
}

FORMATS = tuple(_READERS)
"""Endings of the files that can be read."""


def read_raw(file: str | Path, frame_rate: float | None = None) -> RawMotion:
    """Read a motion capture file of any format.

    Parameters
    ----------
    file : str or Path
        Ending in ``.bvh``, ``.amc`` (its ``.asf`` is searched for) or ``.npz``, in any case.
    frame_rate : float or None, default=None
        Frames per second in place of the file's.

    Returns
    -------
    motion : RawMotion

    Raises
    ------
    InputError
        If it cannot be read; the message names the file, and the line or key that is wrong.
    """
    file = Path(file)
    ending = file.suffix.lower().removeprefix(".")
    if ending not in _READERS:
        raise InputError(
            f"{file}: is no file of motion that can be read; endings are "
            f"{', '.join(f'.{name}' for name in FORMATS)}"
        )
    return _READERS[ending](file, frame_rate)

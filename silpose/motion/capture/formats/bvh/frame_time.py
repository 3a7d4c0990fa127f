"""The frame time of a BVH file, often rounded, and sometimes something else."""

from __future__ import annotations

import re
from dataclasses import dataclass
from decimal import Decimal
from pathlib import Path

from silpose.core.errors import InputError
from silpose.motion.capture.formats.text_file import number, shown

SLOWEST, FASTEST = 1.0, 10_000.0
"""Range of plausible frame rates, frames per second."""

# Rates at which motion is captured, and how far off a rounded frame time is mended without a word.
_USUAL = (24, 25, 30, 48, 50, 60, 72, 90, 100, 120, 144, 150, 180, 200, 240)
_ROUNDED = 0.005


@dataclass(frozen=True)
class FrameTime:
    """A frame time as it is written.

    Attributes
    ----------
    text : str
    line : int
        Line of the file, from 1.
    """

    text: str
    line: int

    def rate(self, file: Path) -> tuple[float, tuple[str, ...]]:
        """Convert it to frames per second.

        Parameters
        ----------
        file : Path
            Named in errors.

        Returns
        -------
        frames_per_second : float
        notes : tuple of str
            Says so if a rounded frame time was taken for that of a usual rate.

        Raises
        ------
        InputError
            If it is no plausible number of seconds.
        """
        plain = re.sub(r"(?<=[\d.])s(ec(onds?)?)?$", "", self.text.strip(",;"), flags=re.IGNORECASE)
        seconds = number(plain)
        if not 1 / FASTEST <= seconds <= 1 / SLOWEST:
            likely = ""
            if 1 / SLOWEST < seconds <= FASTEST:
                likely = (
                    f" ({seconds:g} frames per second would be {1 / seconds:.6f}, "
                    f"{seconds:g} milliseconds {seconds / 1000:.6f})"
                )
            raise InputError(
                f"{file}: line {self.line}: its frame time is {shown(self.text)}; it must be a "
                f"positive number of seconds, {1 / FASTEST:g} to {1 / SLOWEST:g}{likely}; mend it, "
                "or give the rate by motion.frame_rate=30"
            )
        usual = _unrounded(plain, seconds)
        if usual is None:
            return 1 / seconds, ()
        if abs(usual * seconds - 1) < _ROUNDED:
            return float(usual), ()
        note = (
            f"its frame time '{self.text}' is taken for a rounded 1/{usual} of a second; if it is "
            f"not, give motion.frame_rate={1 / seconds:.2f}"
        )
        return float(usual), (note,)


def _unrounded(text: str, seconds: float) -> int | None:
    """Find the one usual rate whose frame time, rounded or cut, is written so."""
    rate = 1 / seconds
    if abs(rate - round(rate)) < 1e-9 * rate:
        return None
    try:
        step = 10.0 ** int(Decimal(text).as_tuple().exponent)
    except (ArithmeticError, ValueError):
        return None
    fits = [usual for usual in _USUAL if -0.51 * step < 1 / usual - seconds < 0.99 * step]
    return fits[0] if len(fits) == 1 else None

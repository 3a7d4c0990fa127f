"""Names of the runs of a sweep: what they vary, in characters that are safe in any path."""

from __future__ import annotations

import re
import zlib
from collections.abc import Sequence

_LONGEST = 80


def run_name(overrides: Sequence[str], varied: Sequence[str]) -> str:
    """Name a run of a sweep.

    Parameters
    ----------
    overrides : sequence of str
        All overrides of the run, as ``key=value``.
    varied : sequence of str
        Names of the settings that the sweep varies.

    Returns
    -------
    name : str
        Such as ``nu_3-seed_1``. What cannot stand in it is replaced, and the name then ends in a
        code of the values, so that no two runs have the same.
    """
    given = dict(override.lstrip("+").split("=", 1) for override in overrides if "=" in override)
    values = {key: given.get(key, "") for key in varied}
    last = [re.split(r"[./]", key)[-1] for key in varied]
    words = [
        f"{short if last.count(short) == 1 else key}_{value}"
        for short, (key, value) in zip(last, values.items(), strict=True)
    ]
    plain = "-".join(words) or "only"
    safe = re.sub(r"[^\w.+-]+", "_", plain)[:_LONGEST]
    return safe if safe == plain else f"{safe.rstrip('_')}-{zlib.crc32(plain.encode()):08x}"

"""Names of cached files by what their content depends on."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any


def digest(settings: Any, files: Iterable[Path] = ()) -> str:
    """Name settings, and the files that they refer to.

    Parameters
    ----------
    settings : plain values, lists and mappings of them
    files : iterable of Path, default=()
        Their names, sizes and times of change count.

    Returns
    -------
    digest : str
        20 characters.
    """
    stats = [(str(f), f.stat().st_size, f.stat().st_mtime_ns) for f in files]
    key = json.dumps([settings, stats], sort_keys=True)
    return hashlib.sha256(key.encode()).hexdigest()[:20]

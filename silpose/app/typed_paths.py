"""Paths in overrides, read as they were typed and not as Hydra's grammar has it."""

from __future__ import annotations

import re
from collections.abc import Sequence

FILES = (
    *("silhouette.source", "model", "motion.root", "dataset.path", "dataset.cache"),
    *("recording.root", "into", "cache"),
    *("silhouette.video.background", "silhouette.video.environment"),
)
"""Settings that are paths of files or folders."""

PATHS = (*FILES, "recording.name", "pattern")
"""Settings that are read as paths are."""

_READY = re.compile(r"'.*'|\".*\"|\$\{[^{}]*\}|null|\?\?\?|", re.DOTALL)


def with_paths_quoted(overrides: Sequence[str], sweep: bool = False) -> list[str]:
    """Quote the values of settings that are paths, so that any character may be in them.

    Parameters
    ----------
    overrides : sequence of str
        As ``key=value``; what is quoted already, or ``null``, stays.
    sweep : bool, default=False
        Whether commas separate values to run one after the other; what can be read as such stays.
    """
    return [_quoted(override, sweep) for override in overrides]


def quoted(text: str) -> str:
    """Quote text so that Hydra reads it back as it is."""
    text = re.sub(r"(\\*)\$\{", lambda found: found[1] * 2 + r"\${", text)  # no interpolation
    text = re.sub(r"(\\*)('|$)", lambda found: found[1] * 2 + (found[2] and r"\'"), text)
    return f"'{text}'"


def _quoted(override: str, sweep: bool) -> str:
    key, equals, value = override.partition("=")
    if not equals or key.lstrip("+") not in PATHS or _READY.fullmatch(value):
        return override
    if sweep and _can_be_read(override):
        return override
    return f"{key}={quoted(value)}"


def _can_be_read(override: str) -> bool:
    from hydra.core.override_parser.overrides_parser import OverridesParser  # --help is faster
    from hydra.errors import HydraException

    try:
        OverridesParser.create().parse_override(override)
    except HydraException:
        return False
    return True

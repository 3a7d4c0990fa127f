"""Settings by their full names and as text, as on the command line."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import yaml


def flat(settings: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, Any]]:
    """Yield nested settings with their full names."""
    for name, value in settings.items():
        if isinstance(value, Mapping):
            yield from flat(value, f"{prefix}{name}.")
        else:
            yield f"{prefix}{name}", value


def typed(value: Any) -> str:
    """Value of a setting as one would type it."""
    text: str = yaml.safe_dump(value, default_flow_style=True, width=10_000)
    return text.removesuffix("...\n").strip()

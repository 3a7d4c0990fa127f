"""How much room a layout has for a table of results."""

from __future__ import annotations

import numpy as np
import rerun.blueprint as rrb

from silpose.recording import entity_paths

_WINDOW = 1024.0  # width of a small one, pixels
_MARGINS = 40.0  # left and right of a table
_CHARACTER = 6.5  # as wide as most are, on average


def room_for_results(layout: rrb.Blueprint) -> int:
    """Characters of a line of the results, in a window of 1024 pixels; 0 without results."""
    share = _share(layout.root_container, entity_paths.METRICS)
    return max(int((_WINDOW * share - _MARGINS) / _CHARACTER), 0)


def _share(part: rrb.Container | rrb.View, origin: str) -> float:
    """Part of a container's width that the view of an entity has; 0 if there is none."""
    if not isinstance(part, rrb.Container):
        return float(part.origin == origin)
    inside = list(part.contents)
    if isinstance(part, rrb.Horizontal):
        given = part.column_shares
        shares = np.ones(len(inside)) if given is None else np.asarray(given, float)
        widths = shares / shares.sum()
    else:
        columns = part.grid_columns if isinstance(part, rrb.Grid) else 1
        widths = np.full(len(inside), 1 / (columns or 1))
    within = [_share(inner, origin) for inner in inside]
    return float(np.max(widths * within, initial=0.0))

"""Words in recordings and figures: of metrics and methods, and what has which colour."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence

from silpose.recording import palette

_UNITS = {"deg": "degrees", "mm": "mm", "m": "metres"}
_METHODS = {
    "aligned_mask_pca": "aligned mask, principal components",
    "hu_moments": "Hu moments",
    "knn": "five nearest neighbours",
    "gmr": "Gaussian mixture",
    "mixture_top1": "most probable mode",
    "nearest": "nearest neighbour",
    "oracle": "nearest true pose (oracle)",
    "ridge": "ridge regression",
    "rvm": "relevance vectors",
    "state_sensitive": "state-sensitive regression",
    "svm": "support vectors",
    "tracker_lag": "tracker with a lag",
}


def in_words(name: str) -> str:
    """Spell a metric's or a method's name out: ``mean angular error, degrees``."""
    if sparse := re.fullmatch(r"rvm_(\d+)", name):
        return f"relevance vectors, {sparse[1]} % kept"
    stem, _, unit = name.rpartition("_")
    if stem and unit in _UNITS:
        return f"{stem.replace('_', ' ').replace('mpjpe', 'mean joint error')}, {_UNITS[unit]}"
    return _METHODS.get(name, name.replace("_", " "))


def coloured(colours: Mapping[str, palette.Colour]) -> str:
    """Say what is drawn in which colour, in place of a legend: ``true (blue), tracker (grey)``."""
    said = (
        f"{in_words(name)} ({palette.NAMES[colour]})" if colour in palette.NAMES else in_words(name)
        for name, colour in colours.items()
    )
    return ", ".join(said)


def facts_in_markdown(facts: Iterable[tuple[str, str]]) -> str:
    """Facts, each below its title in bold, for a pane that wraps text and has any width."""
    return "\n\n".join(f"**{title}** {_literal(words)}" for title, words in facts)


def table_in_markdown(rows: Sequence[Sequence[str]]) -> str:
    """Rows of a table, that of titles first; numbers stand to the right."""
    head, *others = (" | ".join(map(_literal, row)) for row in rows)
    ruler = " | ".join([":--", *["--:"] * (len(rows[0]) - 1)])
    return "\n".join(f"| {line} |" for line in (head, ruler, *others))


def _literal(words: str) -> str:
    """Words of which nothing is read as markup."""
    return re.sub(r"([\\`*_<\[|])", r"\\\1", words)

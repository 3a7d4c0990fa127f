"""Reports in words of what is in masks: of one source, or of the takes of a tree."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from silpose.core.types import Row
from silpose.silhouette.masks import MaskSequence, NumberedFrames
from silpose.silhouette.person import SIDES, MaskFacts

_LISTED = 5
_WIDTH = 12  # of the first column


@dataclass(frozen=True)
class SeenTake:
    """What is known of one take.

    Attributes
    ----------
    name : str
        Its path in a tree; empty for a source by itself.
    sequence : MaskSequence
        As it was read; its masks are not used here.
    shapes : ndarray of int, shape (F, 2)
        Heights and widths of its masks.
    facts : MaskFacts or None
        What was found in the masks, if there are people.
    refused : str
        Why its masks cannot be used as they are; empty if they can.
    """

    name: str
    sequence: MaskSequence
    shapes: np.ndarray
    facts: MaskFacts | None
    refused: str = ""

    @property
    def called(self) -> list[str]:
        """Names of the masks, with that of the take."""
        before = f"{self.name}/" if self.name else ""
        return [f"{before}{name}" for name in self.sequence.names]

    def rows(self) -> list[Row]:
        """Lines of the table, one for each mask."""
        facts, own = self.facts, {"take": self.name} if self.name else {}
        rows: list[Row] = [
            own | {"frame": frame, "file": name, "height": int(height), "width": int(width)}
            for frame, (name, (height, width)) in enumerate(
                zip(self.sequence.names, self.shapes, strict=True)
            )
        ]
        if facts is not None:
            for frame, (row, state) in enumerate(zip(rows, facts.states(), strict=True)):
                row |= {
                    "people": int(facts.people[frame]),
                    "state": state or "person",
                    "cut": int(facts.cut[frame]),
                    "dropped": int(facts.dropped[frame]),
                    "dropped_area": f"{facts.dropped_area[frame]:.4g}",
                }
        return rows


def report(takes: Sequence[SeenTake], rate: float | None = None) -> list[list[tuple[str, str]]]:
    """Describe takes, those that are encoded alike together.

    Parameters
    ----------
    takes : sequence of SeenTake
    rate : float, optional
        Frames per second that are used instead of the source's own.

    Returns
    -------
    facts : list of list of tuple
        For each encoding, titles and what they say.
    """
    kinds: dict[str, list[SeenTake]] = {}
    for take in takes:
        kinds.setdefault(take.sequence.encoding, []).append(take)
    return [_kind(encoding, own, rate) for encoding, own in kinds.items()]


def in_columns(facts: Sequence[tuple[str, str]]) -> str:
    """Write titles in a column, and beside it what they say."""
    return "\n".join(f"{title:<{_WIDTH}}{words}" for title, words in facts)


def _kind(encoding: str, takes: Sequence[SeenTake], rate: float | None) -> list[tuple[str, str]]:
    lines = [("encoding", encoding)]
    if takes[0].name:
        lines += [("takes", f"{len(takes)}: {shortened([take.name for take in takes])}")]
    lines += [("masks", _sizes(np.concatenate([take.shapes for take in takes])))]
    lines += [("rate", _rates(takes) + (f"; {rate:.6g} are used" if rate else ""))]
    for take in takes:
        before = f"of {take.name}, " if take.name else ""
        lines += [("decided", before + note) for note in take.sequence.notes]
        lines += [("in time", before + words) for words in _in_time(take.sequence)]
        lines += [("left out", before + words) for words in _left_out(take.sequence.ignored)]
    lines += _people([take for take in takes if take.facts is not None])
    refused = [take.refused for take in takes if take.refused]
    lines += [("to do", words) for words in refused[:_LISTED]]
    if len(refused) > _LISTED:
        lines += [("", f"and so in {len(refused) - _LISTED} more takes")]
    return lines


def _in_time(sequence: MaskSequence) -> list[str]:
    doubt = NumberedFrames.of(sequence.names).doubt(sequence.source, "masks")
    return [doubt] if doubt else []


def _sizes(shapes: np.ndarray) -> str:
    low, high = shapes.min(axis=0), shapes.max(axis=0)
    spans = [f"{a}" if a == b else f"{a} to {b}" for a, b in zip(low, high, strict=True)]
    return f"{len(shapes)} of {' x '.join(spans)} pixels, height x width"


def _rates(takes: Sequence[SeenTake]) -> str:
    rates = sorted({take.sequence.frames_per_second or 0 for take in takes})
    return ", ".join(
        f"{rate:.6g} frames per second" if rate else "none of its own" for rate in rates
    )


def _left_out(ignored: Sequence[str]) -> list[str]:
    """Join the files that were left out for the same reason."""
    names: dict[str, list[str]] = {}
    for words in ignored:
        name, _, reason = words.rpartition(": ")
        names.setdefault(reason, []).append(name)
    return [f"{_counted(len(n), 'file')} ({why}): {shortened(n)}" for why, n in names.items()]


def _people(takes: Sequence[SeenTake]) -> list[tuple[str, str]]:
    if not takes:
        return []
    facts = MaskFacts.concatenate([take.facts for take in takes if take.facts is not None])
    names = [name for take in takes for name in take.called]
    counts = sorted(Counter(facts.people.tolist()).items())
    sides = [side for side, cut in zip(SIDES, facts.cut_sides.T, strict=True) if cut.any()]
    dropped = facts.dropped > 0
    share = f", at most {100 * facts.dropped_area.max(initial=0):.2g} % of the foreground"
    return [
        ("people", ", ".join(f"{people} in {_counted(n, 'mask')}" for people, n in counts)),
        ("blank", _where(facts.blank, names)),
        ("fragments", _where(facts.fragment, names)),
        ("filled", _where(facts.filled, names)),
        ("cut", _where(facts.cut, names) + (f", at the {', '.join(sides)}" if sides else "")),
        ("dropped", _where(dropped, names) + (share if dropped.any() else "")),
    ]


def _where(flags: np.ndarray, names: Sequence[str]) -> str:
    """Count masks, and name the first of them."""
    frames = np.flatnonzero(flags)
    if not len(frames):
        return "none"
    return f"{len(frames)}: {shortened([names[frame] for frame in frames.tolist()])}"


def shortened(words: Sequence[str]) -> str:
    """List the first words, and count the rest."""
    more = len(words) - _LISTED
    return ", ".join(words[:_LISTED]) + (f" and {more} more" if more > 0 else "")


def _counted(number: int, noun: str) -> str:
    return f"{number} {noun}{'s' if number != 1 else ''}"

"""What is in a user's own masks: how they are read, and what may be wrong with them."""

from __future__ import annotations

import warnings
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np

from silpose.core.errors import InputError
from silpose.core.parameters import POSITIVE_INTEGER, check_values
from silpose.core.progress import bar
from silpose.core.stages import stage
from silpose.core.types import Mask
from silpose.experiments.masks_figure import masks_figure
from silpose.experiments.masks_report import SeenTake, in_columns, report, shortened
from silpose.experiments.setup import Components
from silpose.recording import Recording, Result, record_study
from silpose.recording.captions import facts_in_markdown
from silpose.silhouette.mask_tree import find_takes, is_tree
from silpose.silhouette.masks import MaskSequence, MaskSource, read_masks
from silpose.silhouette.person import MaskFacts, select_person


def masks(components: Components, *, shown: int = 24, takes: int = 100) -> Result:
    """Report how the user's masks are read, and who is in them; the figure shows some of them.

    Of a tree of takes, takes that are encoded alike are reported together.

    Parameters
    ----------
    components : Components
    shown : int, default=24
        Number of masks in the figure, evenly over the source; of a tree one of each take.
    takes : int, default=100
        Most takes of a tree that are read, evenly over it.
    """
    check_values("shown", POSITIVE_INTEGER, shown)
    check_values("takes", POSITIVE_INTEGER, takes)
    own = components.masks
    if own.source is None:
        raise InputError("there are no masks: add silhouette=masks silhouette.source=FOLDER")
    with stage("masks"):
        if is_tree(own.source):
            seen, pictures, summary = _see_tree(own, takes)
        else:
            take, kept, _ = _see(read_masks(own.source, own), own.person)
            seen, pictures, summary = [take], (take.sequence, kept, take.facts), ""
    record = partial(record_study, series={}, title="", frames_per_second=15.0)
    facts = report(seen, own.frames_per_second)
    told = "\n\n".join(map(in_columns, facts))
    count = f"{sum(len(take.shapes) for take in seen)} masks"
    return Result(
        Path(own.source).name,
        {},
        rows=[row for take in seen for row in take.rows()],
        figure=masks_figure(*pictures, shown),
        recording=Recording("\n\n".join([count, *map(facts_in_markdown, facts)]), record),
        summary=count,
        report=f"{told}\n\n{summary}" if summary else told,
    )


def _see(
    sequence: MaskSequence, person: str | None, name: str = ""
) -> tuple[SeenTake, list[Mask], tuple[str, ...]]:
    """Find people as `predict` would; what it would refuse is said beside what is there."""
    refused, facts, kept, doubts = "", None, sequence.masks, sequence.doubts
    for choice in dict.fromkeys((person, person or "largest")):
        try:
            chosen = select_person(
                sequence.masks, choice, names=sequence.names, source=sequence.source
            )
        except InputError as error:
            refused = refused or str(error)
        else:
            kept, facts, doubts = chosen.masks, chosen.facts, (*doubts, *chosen.doubts)
            break
    shapes = np.array([mask.shape for mask in sequence])
    return SeenTake(name, sequence, shapes, facts, refused), kept, doubts


def _see_tree(
    own: MaskSource, most: int
) -> tuple[list[SeenTake], tuple[MaskSequence, list[Mask], MaskFacts | None], str]:
    """Read takes evenly over a tree; of each, the middle mask is for the figure."""
    assert own.source is not None
    found = list(find_takes(own.source))
    some = [found[k] for k in np.unique(np.linspace(0, len(found) - 1, most).round().astype(int))]
    seen: list[SeenTake] = []
    middle: list[Mask] = []
    kept: list[Mask] = []
    doubts: list[str] = []
    bad: list[str] = []
    with bar("masks", len(some)) as advance, warnings.catch_warnings():
        warnings.simplefilter("ignore")  # doubts are told together
        for take in some:
            advance(1)
            try:
                of_take, people, said = _see(read_masks(take.path, own), own.person, take.name)
            except InputError as error:
                bad.append(str(error))
                continue
            doubts += said
            sequence = of_take.sequence
            middle.append(sequence[len(sequence) // 2])
            kept.append(people[len(sequence) // 2])
            seen.append(replace(of_take, sequence=replace(sequence, masks=[])))
    if not seen:
        raise InputError(bad[0])
    lines = [f"{len(some)} of {len(found)} takes were read"] if len(some) < len(found) else []
    lines += [f"{len(bad)} takes cannot be read: {shortened(bad)}"] if bad else []
    lines += [f"{len(doubts)} doubts: {shortened(doubts)}"] if doubts else []
    encodings = "; ".join(dict.fromkeys(take.sequence.encoding for take in seen))
    sheet = MaskSequence(middle, [take.name for take in seen], own.source, encodings)
    return seen, (sheet, kept, None), "\n".join(lines)

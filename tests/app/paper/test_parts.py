import pytest

from silpose.app.paper.options import PaperOptions
from silpose.app.paper.parts import PARTS, parts_of
from silpose.core.errors import InputError
from silpose.recording.paper import CLAIMS


def test_every_experiment_that_a_claim_needs_is_a_part():
    needed = {claim.experiment for claim in CLAIMS} - {None, "video"}
    assert needed == {part.experiment for part in PARTS}


def test_seeds_protocols_and_films_add_runs():
    plain = parts_of(PaperOptions(seeds=1))
    assert len(plain) == len(PARTS)
    spread = sum(part.spread for part in PARTS)
    assert len(parts_of(PaperOptions(seeds=3))) == len(PARTS) + 2 * spread
    more = parts_of(PaperOptions(seeds=1, authors="a.mat", video="film.mp4"))
    assert {part.protocol for part in more} == {"walkers", "authors", "film"}
    assert len({(part.experiment, part.name) for part in more}) == len(more)


def test_a_part_that_does_not_exist_is_named():
    with pytest.raises(InputError, match=r"no 'bridge'.*bridges"):
        parts_of(PaperOptions(parts=("bridge",)))

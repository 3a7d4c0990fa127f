import pytest

from silpose.experiments import EXPERIMENTS
from silpose.recording.paper import CLAIMS, Claim, Found


def test_every_claim_is_reproduced_by_an_experiment_or_says_why_not():
    for claim in CLAIMS:
        assert claim.reason if claim.experiment is None else claim.agrees, claim.says
        assert claim.experiment in (None, "video", *EXPERIMENTS)
        assert not claim.holds or (claim.ours and claim.differs), claim.says


@pytest.mark.parametrize("kept, word", [(0.1, "reproduced"), (0.9, "differs")])
def test_the_verdict_follows_from_what_was_found(finished_run, kept, word):
    bridges = next(claim for claim in CLAIMS if claim.experiment == "bridges")
    found = Found([finished_run("bridges", {"rvm": {"kept": kept, "iterations": 20}})])
    assert bridges.verdict(found)[0] == word
    assert bridges.ours(found).startswith(f"{100 * kept:.0f} % of the columns")


def test_without_an_experiment_or_a_run_the_reason_is_given():
    assert Claim("II", "data", "x", reason="gone").verdict(None) == ("cannot be had", "gone")
    word, sentence = Claim("II", "text", "x", experiment="tracking").verdict(None)
    assert word == "not run" and "experiment=tracking" in sentence

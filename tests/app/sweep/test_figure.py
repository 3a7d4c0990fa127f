from pathlib import Path

import pytest

from silpose.app.sweep.figure import sweep_figure
from silpose.app.sweep.outcomes import Outcome
from silpose.recording import FinishedRun


def outcome(headline, **varied):
    run = FinishedRun(Path("x"), "e", "walker", {}, {}, "", headline)
    return Outcome(Path("x"), varied, run)


def test_a_line_goes_through_the_means_over_seeds():
    ready = [outcome(w + s, width=w, seed=s) for w in (0.1, 1, 10) for s in (0, 2)]
    (axes,) = sweep_figure(ready, "a sweep").axes
    dots, line = axes.lines
    assert len(dots.get_xdata()) == 6
    assert line.get_ydata() == pytest.approx([1.1, 2, 11])
    assert axes.get_xscale() == "log"
    assert axes.get_xlabel() == "width"


def test_of_two_settings_the_one_with_fewer_values_makes_the_lines():
    ready = [outcome(1.0, width=w, kind=k) for w in (1, 2, 3) for k in ("a", "b")]
    (axes,) = sweep_figure(ready, "a sweep").axes
    labels = [text.get_text() for text in axes.get_legend().get_texts()]
    assert labels == ["kind=a", "kind=b"]


def test_words_and_seeds_have_places_too():
    (axes,) = sweep_figure([outcome(1.0, kind=k) for k in ("robust", "authors")], "t").axes
    assert [text.get_text() for text in axes.get_xticklabels()] == ["robust", "authors"]
    (axes,) = sweep_figure([outcome(float(s), seed=s) for s in range(3)], "t").axes
    assert axes.get_xlabel() == "seed"
    assert list(axes.lines[1].get_ydata()) == [1.0, 1.0]  # the mean


def test_without_headlines_there_is_no_figure():
    assert sweep_figure([outcome(None, seed=1)], "t") is None

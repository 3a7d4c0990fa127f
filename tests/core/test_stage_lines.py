import io
import time

import pytest
from rich.console import Console

from silpose.core import stage_lines as module
from silpose.core.progress import bar
from silpose.core.stage_lines import animated, stage_lines
from silpose.core.stages import stage, timing


@pytest.fixture
def terminal(monkeypatch):
    """What is drawn in a terminal."""
    drawn = io.StringIO()
    made = Console(file=drawn, force_terminal=True, width=60, legacy_windows=False)
    monkeypatch.setattr(module, "Console", lambda **_: made)
    for name in ("NO_COLOR", "TERM"):
        monkeypatch.delenv(name, raising=False)
    return drawn


def test_every_stage_leaves_a_line_that_says_how_it_ended(terminal):
    with stage_lines():
        for _ in range(2):
            with stage("masks"):
                pass
        with pytest.raises(ValueError, match="why"), stage("regression"):
            raise ValueError("why")
    last = terminal.getvalue().rpartition("\x1b[2K")[2] + terminal.getvalue()[-400:]
    assert "✓" in last and "✗" in last
    assert "masks" in last and "regression" in last and "0.0 s" in last


def test_a_bar_is_in_the_line_of_the_stage_that_runs(terminal, monkeypatch):
    monkeypatch.setattr(module, "_PER_SECOND", 50.0)
    with stage_lines(), stage("masks"), bar("rendering", 4) as advance:
        advance(3)
        time.sleep(0.2)
        with stage("inner"):
            pass
    assert "rendering 3/4" in terminal.getvalue()
    assert "inner" not in terminal.getvalue()


def test_a_run_after_another_has_lines_of_its_own(terminal):
    with stage_lines():
        for _ in range(2):
            with timing(), stage("masks"):
                pass
    assert terminal.getvalue().count("\x1b[?25l") == 2  # the cursor is hidden while lines change


def test_without_a_terminal_a_stage_is_named_once(capsys):
    with stage_lines(), timing():
        for name in ("masks", "masks", "regression"):
            with stage(name), bar(name, 2) as advance:
                advance(1)
    assert capsys.readouterr().err.splitlines() == ["masks …", "regression …"]


@pytest.mark.parametrize(("name", "value"), [("NO_COLOR", "1"), ("TERM", "dumb")])
def test_plain_text_is_plain(monkeypatch, name, value):
    monkeypatch.delenv("NO_COLOR", raising=False)
    monkeypatch.setenv("TERM", "xterm")
    assert animated(Console(force_terminal=True))
    monkeypatch.setenv(name, value)
    assert not animated(Console(force_terminal=True))

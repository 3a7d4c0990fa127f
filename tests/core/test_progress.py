import io

from rich.console import Console

from silpose.core import progress


def test_a_bar_is_drawn_only_when_it_takes_long(monkeypatch):
    drawn = io.StringIO()
    monkeypatch.setattr(progress, "Console", lambda **_: Console(file=drawn, force_terminal=True))
    with progress.bar("masks", 3) as advance:
        advance(1)
    assert drawn.getvalue() == ""
    monkeypatch.setattr(progress, "_PATIENCE", -1.0)
    with progress.bar("masks", 3) as advance:
        advance(1)
    assert "masks" in drawn.getvalue()

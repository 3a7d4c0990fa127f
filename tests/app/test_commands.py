import sys

import pytest

from silpose.app.main import main


def test_finished_runs_have_commands_of_their_own(finished, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "argv", ["silpose", "compare", str(finished.folder), "nowhere"])
    with pytest.raises(SystemExit, match="silpose: 'nowhere' holds no finished run"):
        main()
    monkeypatch.setattr(sys, "argv", ["silpose", "picture", "nowhere.rrd"])
    with pytest.raises(SystemExit, match=r"silpose: there is no recording 'nowhere\.rrd'"):
        main()
    monkeypatch.setattr(sys, "argv", ["silpose", "film", "--help"])
    with pytest.raises(SystemExit):
        main()
    assert "--every" in capsys.readouterr().out

from pathlib import Path

from silpose.core.home_folder import expanded


def test_a_tilde_is_the_home_folder_where_there_is_one(monkeypatch):
    monkeypatch.setenv("HOME", "/somewhere")
    assert expanded("~/masks") == Path("/somewhere/masks")
    assert expanded("a/~b") == Path("a/~b")
    assert expanded("~no such user/masks") == Path("~no such user/masks")

import pytest

from silpose.app.config import load, plain
from silpose.app.settings_table import print_settings, tables
from silpose.app.terminal import wrapped
from silpose.core.errors import InputError


def test_values_are_those_of_the_overrides():
    given = plain(load(["regression.ridge.damping=[1,2]", "motion=bvh"]))
    (row,) = tables("regression.ridge", given)["regression.ridge"]
    assert row[:3] == ("damping", "[1, 2]", "a number or auto")
    assert row[3]
    assert tables("motion", given)["motion"][0][:2] == ("root", "(must be given)")


def test_a_group_shows_its_parts_and_a_part_only_itself():
    given = plain(load())
    whole = tables("silhouette", given)
    assert {"silhouette", "silhouette.body", "silhouette.scenes"} <= set(whole)
    assert set(tables("silhouette.body", given)) == {"silhouette.body"}


def test_an_experiments_own_parameters_are_shown(capsys):
    print_settings(["experiment"], ["experiment=hypotheses", "trials=3"])
    shown = capsys.readouterr().out
    assert "blank_frames" in shown
    assert "trials" in shown
    assert "None" not in shown


def test_without_a_group_all_groups_and_choices_are_shown(capsys):
    print_settings([], ["motion=bvh"])
    lines = capsys.readouterr().out.splitlines()
    (motion,) = [line.split() for line in lines if line.startswith("motion")]
    assert motion == ["motion", "bvh", "amass,", "walker"]
    assert any(line.startswith("n_jobs") for line in lines)


def test_names_are_whole_in_a_narrow_terminal(capsys):
    print_settings(["silhouette/scenes", "regression.mixture"])
    shown = capsys.readouterr().out
    assert "calibration_exponent" in shown
    assert "focal_length" in shown


def test_a_misspelt_group_is_named():
    with pytest.raises(InputError, match=r"no group 'regresion'; did you mean 'regression'\?"):
        print_settings(["regresion"])


@pytest.mark.parametrize("columns", [60, 80, 100])
@pytest.mark.parametrize("group", ["experiment", "silhouette", "regression", "tracking", "fitting"])
def test_words_are_whole_in_narrow_terminals(capsys, monkeypatch, group, columns):
    monkeypatch.setenv("COLUMNS", str(columns))
    print_settings([group])
    shown = {word.strip("()") for word in capsys.readouterr().out.split()}
    rows = [row for rows in tables(group, plain(load())).values() for row in rows]
    described = {word.strip("()") for row in rows for cell in row for word in cell.split()}
    assert described <= shown


def test_long_names_break_after_dots_and_underscores_in_the_narrowest_terminals(
    capsys, monkeypatch
):
    monkeypatch.setenv("COLUMNS", "24")
    print_settings(["regression.mixture"])
    words = capsys.readouterr().out.split()
    assert "calibration_" in words or "calibration_exponent" in words
    assert wrapped("see regression.mixture.calibration_exponent", 24).splitlines() == [
        "see regression.mixture.",
        "calibration_exponent",
    ]


@pytest.mark.parametrize("columns", [60, 40])
def test_nothing_is_cut_in_a_narrow_terminal(capsys, monkeypatch, columns):
    monkeypatch.setenv("COLUMNS", str(columns))
    print_settings()
    print_settings(["regression.basis"])
    assert "…" not in capsys.readouterr().out

import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.model.trees.tree_index import TreeIndex

SETTINGS = {"model": "abc", "lag": 0.5}
COUNTS = {"masks": 3, "blank": 0, "cut": 0, "doubtful": 0, "tracking": 0}
ROW = {"take": 'a,"b"', "table": "t.csv", "source_changed": 7} | COUNTS


def test_lines_are_read_back_though_the_last_was_cut_off(tmp_path):
    index = TreeIndex.open(tmp_path / "index", SETTINGS)
    index.add(ROW)
    index.add(ROW | {"take": "c"})
    file = tmp_path / "index" / "takes.csv"
    file.write_text(file.read_text()[:-4])
    again = TreeIndex.open(tmp_path / "index", SETTINGS)
    assert list(again.rows) == ['a,"b"']
    again.add(ROW | {"take": "d"})  # begins a line of its own
    assert list(TreeIndex.open(tmp_path / "index", SETTINGS).rows) == ['a,"b"', "d"]


def test_a_take_is_done_if_its_table_is_there_and_nothing_changed(tmp_path):
    index = TreeIndex.open(tmp_path / "index", SETTINGS)
    index.add(ROW)
    assert not index.is_done(ROW["take"], 7)
    (tmp_path / "index" / "t.csv").write_text("")
    assert index.is_done(ROW["take"], 7)
    assert not index.is_done(ROW["take"], 8) and not index.is_done("other", 7)
    index.add(ROW | {"error": "no image"})
    assert not index.is_done(ROW["take"], 7)


def test_the_finished_index_has_the_trees_order_and_levels(tmp_path):
    index = TreeIndex.open(tmp_path / "index", SETTINGS)
    for take in ("b/2", "a/1"):
        index.add(ROW | {"take": take})
    order = [("a/1", ["a", "1"]), ("b/2", ["b", "2"]), ("c/3", ["c", "3"])]
    index.finish(order, ["subject", "view"])
    lines = (tmp_path / "index" / "takes.csv").read_text().splitlines()
    assert lines[0].startswith("take,subject,view,table,")
    assert [line.split(",")[:3] for line in lines[1:]] == [["a/1", "a", "1"], ["b/2", "b", "2"]]
    assert list(TreeIndex.open(tmp_path / "index", SETTINGS).rows) == ["a/1", "b/2"]


def test_a_place_that_cannot_be_written_to_is_named(read_only):
    with pytest.raises(InputError, match="into=FOLDER"):
        TreeIndex.open(read_only / "index", SETTINGS)


@pytest.mark.parametrize("content", [b"{", b"[1]", b"\xff\xfe", b""])
def test_settings_that_were_damaged_are_named(tmp_path, content):
    TreeIndex.open(tmp_path / "index", SETTINGS)
    (tmp_path / "index" / "settings.json").write_bytes(content)
    with pytest.raises(InputError, match=r"settings\.json' is damaged .*into=FOLDER"):
        TreeIndex.open(tmp_path / "index", SETTINGS)


def test_lines_that_are_no_longer_whole_are_left_out(tmp_path):
    index = TreeIndex.open(tmp_path / "index", SETTINGS)
    index.add(ROW)
    file = tmp_path / "index" / "takes.csv"
    whole = file.read_bytes()
    random = np.random.default_rng(0)
    for _ in range(200):
        damaged = bytearray(whole)
        damaged[random.integers(len(whole))] = random.integers(256)
        file.write_bytes(damaged)
        try:
            rows = TreeIndex.open(tmp_path / "index", SETTINGS).rows.values()
        except InputError as error:
            assert "is damaged" in str(error)
            continue
        assert all(row["error"] or int(row["masks"]) >= 0 for row in rows)

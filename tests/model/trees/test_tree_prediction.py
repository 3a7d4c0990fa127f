import csv
import shutil
import warnings
from dataclasses import replace

import cv2
import numpy as np
import pytest
from joblib import parallel_config

from silpose.core.errors import InputError
from silpose.model import predict_tree
from silpose.model.trees import read_table
from silpose.silhouette.masks import MaskSource
from silpose.tracking import BeliefTracker

pytestmark = pytest.mark.filterwarnings("ignore:this model was trained without")


def predicted(model, root, **given):
    """Poses of a tree in a folder beside it."""
    return predict_tree(model, root, root.with_name("root_poses"), **given)


def index(folder):
    with (folder / "takes.csv").open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def written(folder):
    return {file: file.stat().st_mtime_ns for file in folder.rglob("*.csv")}


def test_every_take_gets_a_table_and_a_line_in_the_index(small_model, tree, tmp_path):
    answer = predicted(small_model, tree, pattern="subject/sequence/view")
    assert answer.folder == tmp_path / "root_poses"
    assert answer.summary() == (f"3 takes, 15 masks, 1 blank: see {answer.folder / 'takes.csv'}")
    rows = index(answer.folder)
    assert [row["take"] for row in rows] == ["001/nm-01/090", "001/nm-02/090", "002/nm-01/090"]
    assert [(r["subject"], r["sequence"], r["view"]) for r in rows][2] == ("002", "nm-01", "090")
    assert [row["blank"] for row in rows] == ["0", "1", "0"]
    for row in rows:
        table = read_table(answer.folder / row["table"])
        expected = small_model.predict(tree / row["take"], blank="nan")
        np.testing.assert_allclose(table["heading_deg"], expected.heading, rtol=1e-4)
        assert table["file"].tolist() == [f"{k:03d}.png" for k in range(5)]


def test_what_is_finished_is_not_done_again(small_model, tree):
    first = predicted(small_model, tree)
    before = written(first.folder)
    again = predicted(small_model, tree)
    assert again.done_before == 3 and again.counts == first.counts
    after = written(first.folder)
    index_file = first.folder / "takes.csv"
    assert {f: t for f, t in after.items() if f != index_file} == {
        f: t for f, t in before.items() if f != index_file
    }


def test_a_killed_run_goes_on_where_it_was(small_model, tree):
    whole = predicted(small_model, tree)
    rows = index(whole.folder)
    text = (whole.folder / "takes.csv").read_text()
    lines = text.splitlines(keepends=True)
    before = written(whole.folder)
    # The first take is in the index, the second's table is finished, the third is not begun.
    (whole.folder / "takes.csv").write_text(lines[0] + lines[1] + lines[2][:9])
    (whole.folder / rows[2]["table"]).unlink()
    answer = predicted(small_model, tree)
    assert answer.done_before == 1 and answer.counts == whole.counts
    assert index(whole.folder) == rows
    after = written(whole.folder)
    kept = [whole.folder / row["table"] for row in rows[:2]]
    assert [after[file] for file in kept] == [before[file] for file in kept]


def test_a_take_that_changed_is_done_again(small_model, tree, sequence):
    predicted(small_model, tree)
    cv2.imwrite(str(tree / "001" / "nm-01" / "090" / "005.png"), 255 * sequence.masks[20])
    answer = predicted(small_model, tree)
    assert answer.done_before == 2 and answer.counts["masks"] == 16


def test_a_bad_take_is_named_and_skipped_and_tried_again(small_model, tree, sequence):
    bad = tree / "001" / "nm-02" / "090" / "001.png"
    whole = bad.read_bytes()
    bad.write_bytes(whole[:40])
    with pytest.warns(UserWarning, match=r"1 take could not be used.*001/nm-02/090.*001\.png"):
        answer = predicted(small_model, tree)
    assert (answer.takes, answer.failed, answer.counts["masks"]) == (3, 1, 10)
    assert "001.png" in index(answer.folder)[1]["error"]
    bad.write_bytes(whole)
    with warnings.catch_warnings():
        warnings.simplefilter("error", UserWarning)
        warnings.filterwarnings("ignore", "this model was trained without")
        again = predicted(small_model, tree)
    assert (again.done_before, again.failed, again.counts["masks"]) == (2, 0, 15)


def test_doubts_about_a_take_are_in_the_index(small_model, tree, sequence):
    wide = tree / "003" / "stretched"
    wide.mkdir(parents=True)
    for frame, mask in enumerate(sequence.masks[:5]):
        rows, columns = (np.flatnonzero(mask.any(axis=axis)) for axis in (1, 0))
        crop = mask[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
        stretched = cv2.resize(255 * crop, (80, 80), interpolation=cv2.INTER_NEAREST)
        cv2.imwrite(str(wide / f"{frame}.png"), np.pad(stretched, 8))
    with pytest.warns(UserWarning, match=r"1 take may be wrong.*003/stretched"):
        answer = predicted(small_model, tree)
    doubts = [row["doubts"] for row in index(answer.folder)]
    assert doubts[:3] == ["", "", ""] and "stretched" in doubts[3]


def test_tables_of_other_settings_are_not_mixed(small_model, tree, tmp_path, sequence):
    predicted(small_model, tree)
    with pytest.raises(InputError, match=r"another person \(None there, left now\).*into=FOLDER"):
        predicted(small_model, tree, options=MaskSource(person="left"))
    other = replace(small_model)
    other.regressor = type(other.regressor)(damping=1.0).fit(
        small_model.descriptor.transform(sequence.masks), sequence.x
    )
    with pytest.raises(InputError, match="another model"):
        predicted(other, tree)
    shutil.copytree(tree, tmp_path / "copy" / "root")
    with pytest.raises(InputError, match=r"poses of another tree .*into=FOLDER"):
        predict_tree(small_model, tmp_path / "copy" / "root", tree.with_name("root_poses"))
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "thesis.txt").write_text("")
    with pytest.raises(InputError, match=r"holds other files.*into=FOLDER"):
        predict_tree(small_model, tree, tmp_path / "full")


def test_parquet_holds_the_same(small_model, tree, tmp_path):
    pytest.importorskip("pyarrow")
    csv_folder = predict_tree(small_model, tree, tmp_path / "csv").folder
    folder = predict_tree(small_model, tree, tmp_path / "parquet", table="parquet").folder
    one, other = (read_table(f / f"001/nm-02/090.{f.name}") for f in (csv_folder, folder))
    assert list(one) == list(other)
    for name, values in one.items():
        if values.dtype.kind == "f":
            np.testing.assert_allclose(other[name], values, rtol=1e-4, atol=1e-6)
        else:
            assert other[name].tolist() == values.tolist()
    with pytest.raises(InputError, match="table must be"):
        predicted(small_model, tree, table="xlsx")


def test_a_tracker_asks_for_the_rate_before_the_work(small_model, tree, tmp_path, sequence):
    z = small_model.descriptor.transform(sequence.masks)
    tracking = replace(small_model, tracker=BeliefTracker(keep=0.5).fit([(z, sequence.x)]))
    with pytest.raises(InputError, match=r"silhouette\.frames_per_second=15"):
        predict_tree(tracking, tree, tmp_path / "tracked")
    options = MaskSource(frames_per_second=30)
    answer = predict_tree(tracking, tree, tmp_path / "tracked", options=options)
    table = read_table(answer.folder / "001" / "nm-02" / "090.csv")
    assert np.isfinite(table["heading_deg"]).all()  # the blank one, too
    np.testing.assert_allclose(table["time"], np.arange(5) / 30, atol=1e-5)


def test_a_tree_without_takes_says_what_is_expected(small_model, tree, tmp_path):
    (tmp_path / "nothing").mkdir()
    with pytest.raises(InputError, match=r"no masks below .*nothing'"):
        predicted(small_model, tmp_path / "nothing")
    with pytest.raises(InputError, match=r"fits pattern=subject/view: .* such as '001/nm-01/090'"):
        predicted(small_model, tree, pattern="subject/view")


def test_several_processes_give_the_same(small_model, tree, tmp_path, monkeypatch):
    alone = predict_tree(small_model, tree, tmp_path / "alone")
    monkeypatch.setattr("silpose.model.trees.tree_prediction._FEW", 0)
    with parallel_config(n_jobs=2):
        both = predict_tree(small_model, tree, tmp_path / "both")
    assert both.counts == alone.counts
    name = "002/nm-01/090.csv"
    assert (both.folder / name).read_text() == (alone.folder / name).read_text()


def test_a_tree_of_files_that_are_not_read_says_so(small_model, tmp_path):
    take = tmp_path / "00001" / "090"
    take.mkdir(parents=True)
    (take / "090.pkl").write_bytes(b"x")
    with pytest.raises(InputError, match=r"no masks below .*090\.pkl' holds pickled objects"):
        predicted(small_model, tmp_path, pattern="subject/view")

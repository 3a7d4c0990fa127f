import shutil
from dataclasses import replace

import cv2
import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette import MaskSource


def test_a_source_is_reported(run, walkers, mask_folder):
    reported = run("masks", replace(walkers, masks=MaskSource(str(mask_folder))), shown=5)
    told = dict(line.split(maxsplit=1) for line in reported.result.report.splitlines())
    assert told["encoding"] == "grey values 0 and 255: above 127.5"
    assert told["masks"] == "12 of 96 x 96 pixels, height x width"
    assert told["rate"] == "none of its own"
    assert told["people"] == "0 in 1 mask, 1 in 11 masks"
    assert told["blank"] == "1: 5.png"
    assert told["dropped"] == "none"
    assert [row["state"] == "blank" for row in reported.rows] == [k == 5 for k in range(12)]
    titles = [axes.get_title() for axes in reported.result.figure.axes]
    assert [title for title in titles if title] == ["0.png", "3.png", "6.png", "8.png", "11.png"]


def test_what_predict_refuses_is_said_beside_what_is_there(run, walkers, mask_folder, tmp_path):
    for k in (0, 1, 2):
        mask = cv2.imread(str(mask_folder / f"{k}.png"), cv2.IMREAD_GRAYSCALE)
        cv2.imwrite(str(tmp_path / f"{k}.png"), np.hstack([mask, mask]))
    told = run("masks", replace(walkers, masks=MaskSource(str(tmp_path)))).result.report
    assert "2 in 3 masks" in told and "silhouette.person=" in told


def test_a_source_without_anybody_is_reported(run, walkers, tmp_path):
    cv2.imwrite(str(tmp_path / "0.png"), np.zeros((30, 30), np.uint8))
    own = replace(walkers, masks=MaskSource(str(tmp_path)))
    told = run("masks", own, record=False).result.report
    assert "grey values, all 0" in told and "to do" in told


def test_masks_are_needed(run, walkers):
    with pytest.raises(InputError, match=r"silhouette=masks silhouette\.source"):
        run("masks", walkers)


def test_takes_of_a_tree_that_are_encoded_alike_are_reported_together(
    run, walkers, mask_folder, tmp_path
):
    for take in ("001/a", "001/b", "002/a", "003/a"):
        shutil.copytree(mask_folder, tmp_path / take)
    for file in (tmp_path / "002/a").iterdir():
        mask = cv2.imread(str(file), cv2.IMREAD_GRAYSCALE)
        cv2.imwrite(str(file), mask // 255)
    (tmp_path / "003/a/3.png").write_text("no image")
    reported = run("masks", replace(walkers, masks=MaskSource(str(tmp_path))), record=False)
    first, second, others = reported.result.report.split("\n\n")
    assert "takes       2: 001/a, 001/b" in first and "24 of 96 x 96" in first
    assert "blank       2: 001/a/5.png, 001/b/5.png" in first
    assert "grey values 0 and 1" in second and "takes       1: 002/a" in second
    assert "1 takes cannot be read" in others and "3.png' is no image" in others
    assert {row["take"] for row in reported.rows} == {"001/a", "001/b", "002/a"}
    less = run("masks", replace(walkers, masks=MaskSource(str(tmp_path))), record=False, takes=2)
    assert "2 of 4 takes were read" in less.result.report

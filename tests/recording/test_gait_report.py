import csv
import re
from html.parser import HTMLParser

import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.evaluation.gait import Walk, gait_report
from silpose.motion import Straight, WalkerModel
from silpose.recording.gait_report import TITLES, gait_page, gait_rows, write_gait


@pytest.fixture(scope="module")
def report():
    rng = np.random.default_rng(0)
    walk = WalkerModel.load().sample(rng, 0.3).walk(Straight(), 8.0, 30.0, rng)
    x = ANGLES.from_angles(walk.angles)
    return gait_report(Walk.from_poses(x, frames_per_second=30.0, path=walk.root_position))


@pytest.fixture(scope="module")
def standing():
    x = np.eye(1, 55).repeat(60, axis=0)
    return gait_report(Walk.from_poses(x, frames_per_second=30.0))


def test_the_table_reads_back(report, tmp_path):
    table, _ = write_gait(report, tmp_path)
    with table.open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert tuple(rows[0]) == TITLES
    by_name = {(row["name"], row["side"], row["percent"]): row for row in rows}
    cadence = by_name["cadence", "both", ""]
    assert float(cadence["value"]) == pytest.approx(report["cadence"].value, abs=1e-3)
    assert len(cadence["frames"].split()) == int(cadence["strides"]) == len(report.counted)
    knee = [row for row in rows if row["name"] == "knee_flexion" and row["side"] == "left"]
    assert [int(row["percent"]) for row in knee] == list(range(101))
    assert sum(row["name"] == "strike" for row in rows) == sum(e.strike for e in report.events)


def test_what_is_not_known_is_empty_and_has_a_reason(standing):
    rows = [dict(zip(TITLES, row, strict=True)) for row in gait_rows(standing)[1:]]
    assert {row["value"] for row in rows} == {""}
    assert {row["reason"] for row in rows} == {"the person stands"}


def test_the_page_needs_no_other_file_and_has_both_colours(report, tmp_path):
    _, page = write_gait(report, tmp_path, "A <b>walk</b> & more")
    text = page.read_text(encoding="utf-8")
    HTMLParser().feed(text)
    assert "A &lt;b&gt;walk&lt;/b&gt; &amp; more" in text
    assert not re.search(r'(?:src|xlink:href|href)="(?!#)', text)
    assert "url(http" not in text and "@import" not in text
    assert "prefers-color-scheme: dark" in text
    assert "currentColor" in text and "#010203" not in text
    assert "Walks forward" in text


def test_the_page_of_a_person_who_stands(standing):
    text = gait_page(standing)
    assert "No steps" in text and "No value: the person stands." in text
    assert "nan" not in re.sub(r"<svg.*</svg>", "", text, flags=re.DOTALL).lower()


def test_the_page_is_always_the_same(report):
    assert gait_page(report) == gait_page(report)


def test_where_nothing_can_be_written(report, read_only):
    with pytest.raises(InputError, match="cannot write"):
        write_gait(report, read_only)


def test_on_phones_what_is_wide_scrolls_by_itself(report):
    page = gait_page(report)
    assert page.count('<div class="wide"') == 2
    assert '<div class="wide" tabindex="0"><table>' in page
    assert '<div class="wide" tabindex="0"><svg' in page

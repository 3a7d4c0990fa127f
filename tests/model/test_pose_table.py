import csv
import io

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from silpose.core.pose_space import ANGLES
from silpose.model import Poses, pose_columns, pose_csv


def poses(frames=4, **more):
    x = ANGLES.from_angles(np.random.default_rng(0).uniform(-30, 30, (frames, 54)))
    time = 1234.5 + np.arange(frames) / 29.97
    return Poses(x, ANGLES, np.full(frames, 0.25), ["estimated"] * frames, time, **more)


def read(text):
    return list(csv.DictReader(io.StringIO(text, newline="")))


def test_every_number_can_be_read_back():
    own = poses(iou=np.linspace(0.5, 0.9, 4))
    rows = read(pose_csv(own, list("abcd")))
    assert list(rows[0]) == list(pose_columns(own, list("abcd")))
    for name, column in pose_columns(own, list("abcd")).items():
        if name not in ("file", "state"):
            np.testing.assert_allclose(
                [float(row[name]) for row in rows], column, rtol=1e-5, atol=1e-9
            )
    times = np.diff([float(row["time"]) for row in rows])
    np.testing.assert_allclose(times, 1 / 29.97, atol=2e-6)  # late in a take, too


@given(st.text(st.characters(exclude_categories=["Cs"], exclude_characters="\0")))
@settings(deadline=None, max_examples=40)
def test_any_name_of_a_file_is_kept(name):
    rows = read(pose_csv(poses(1), [name]))
    assert len(rows) == 1 and rows[0]["file"] == name


def test_what_is_not_known_is_nan():
    own = poses()
    own.x[2] = np.nan
    assert read(pose_csv(own, list("abcd")))[2]["heading_deg"] == "nan"

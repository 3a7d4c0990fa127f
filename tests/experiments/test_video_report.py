from dataclasses import replace

import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.experiments.video_report import gait_of, summary_of
from silpose.model import Poses
from silpose.model.video import VideoTrack
from silpose.motion import WalkerTakes
from silpose.recording import gait_page


@pytest.fixture(scope="module")
def track():
    """A perfect track of a walker, at 30 frames a second."""
    walker = WalkerTakes(seconds=6, test_seconds=2, frames_per_second=30, turns=0.3).takes()[0]
    frames = len(walker.angles)
    x, root = ANGLES.from_angles(walker.angles), walker.root_position
    poses = Poses(
        x, ANGLES, np.full(frames, 0.9), ["fitted"] * frames, np.arange(frames) / 30,
        iou=np.full(frames, 0.9),
    )  # fmt: skip
    joints = ANGLES.joints(x) + root[:, None]
    still = np.zeros(frames)
    return VideoTrack(
        np.arange(frames), ["person"] * frames, poses, joints, root, still, still + 1, 1.4, 1.72,
        False,
    )  # fmt: skip


def test_the_report_says_on_what_lengths_rest(track):
    report = gait_of(track)
    assert report["cadence"].value > 60 and 0.5 < report["speed"].value < 2
    assert "body height of 1.72 m" in report.notes[-1]
    larger = {"scale": 1.1 * track.scale, "path": 1.1 * track.path}
    tall = gait_of(replace(track, **larger, height_given=True))
    lengths = [own["stride_length"].value for own in (report, tall)]
    assert lengths[1] == pytest.approx(1.1 * lengths[0], rel=0.01)
    assert "body height" not in " ".join(tall.notes)


def test_a_path_that_nobody_walks_is_left_out(track):
    report = gait_of(replace(track, path=100 * track.path))
    assert report["cadence"].value > 60
    assert any("path in the film is not used" in note for note in report.notes)


def test_too_few_frames_a_second_are_said_to_be_so(track):
    slow = replace(track, poses=replace(track.poses, time=2.0 * np.arange(len(track))))
    report = gait_of(slow)
    assert "needs 0.1 s or less" in report["cadence"].reason
    assert "needs 0.1 s or less" in gait_page(report)


def test_the_summary_tells_what_to_do(track):
    report = gait_of(track)
    good = summary_of(track, report, 0.95)
    assert "overlap 0.90" in good and "steps/min" in good and "\n" not in good
    poor = replace(track.poses, iou=0.5 * track.poses.iou, confidence=np.full(len(track), 0.1))
    assert "silhouette.video.threshold" in summary_of(replace(track, poses=poor), report, 0.95)
    moved = replace(track, seen=["moved"] * len(track))
    assert "The camera moves" in summary_of(moved, report, 0.95)
    away = replace(track, seen=["fragment"] * len(track))
    assert "silhouette.video.background=FILE" in summary_of(away, report, 0.95)

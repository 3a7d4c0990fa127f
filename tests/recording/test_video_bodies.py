from dataclasses import replace

import numpy as np
import pytest
import rerun as rr
from video_steps import video_steps

from silpose.core.pose_space import ANGLES
from silpose.recording import entity_paths as entities
from silpose.recording import palette
from silpose.recording.video_bodies import VideoBodies, bone_colours


@pytest.fixture
def bones_of(tmp_path, logged):
    """Bones (F, B, 2, 3) that are drawn of some steps."""

    def drawn(steps):
        file = tmp_path / "bodies.rrd"
        recording = rr.RecordingStream("test")
        recording.save(file)
        bodies = VideoBodies(recording)
        for frame, step in enumerate(steps):
            recording.set_time("frame", sequence=frame)
            bodies.log(step)
        recording.disconnect()
        return np.array(logged(file, entities.FITTED_SKELETON, "LineStrips3D:strips"))

    return drawn


def test_a_person_is_as_large_and_turned_as_the_step_says(bones_of, sequence):
    (step,) = video_steps(sequence, 1)
    plain, large, turned = bones_of([step, replace(step, scale=2.0), replace(step, azimuth=90.0)])
    root = np.array([0, 0.9, 0])  # the world begins below the first place
    assert large - root == pytest.approx(2 * (plain - root), abs=1e-5)
    quarter = np.array([[0.0, 0, 1], [0, 1, 0], [-1, 0, 0]])  # from +Z to +X
    assert turned - root == pytest.approx((plain - root) @ quarter.T, abs=1e-5)


def test_one_whose_place_is_unknown_stands_on_the_ground_or_stays(bones_of, sequence):
    step, later = video_steps(sequence, 2)
    nowhere = np.full(3, np.nan)
    alone = bones_of([replace(step, place=nowhere)])[0]
    assert alone[..., 1].min() == pytest.approx(0, abs=0.1)
    *_, known, stays = bones_of([step, later, replace(later, place=nowhere)])
    assert stays == pytest.approx(known)


def test_doubtful_poses_have_a_colour_of_their_own(sequence):
    poses = video_steps(sequence, 1)[0].poses
    sure, doubtful = bone_colours(poses), bone_colours(replace(poses, confidence=np.array([0.1])))
    assert len(sure) == len(ANGLES.bones)
    assert palette.ESTIMATED in sure
    assert palette.DOUBTFUL in doubtful

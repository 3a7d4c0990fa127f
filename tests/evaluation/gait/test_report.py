from dataclasses import replace

import numpy as np
import pytest
from gait_truth import gait_errors, source_feet, true_strides, world_feet
from hypothesis import given, settings
from hypothesis import strategies as st
from synthetic import motion

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.evaluation.gait import PARAMETERS, Walk, gait_report
from silpose.motion import Circle, Motion, MotionFolder

LIMITS = {"cadence": 2.0, "stride_time": 3.0, "stride_length": 5.0}
"""Largest median error, percent."""


def check(errors):
    for name, limit in LIMITS.items():
        assert np.median([abs(own[name]) for own in errors]) < limit, name


@pytest.mark.parametrize("every", [4, 8])
@pytest.mark.parametrize("path", [True, False])
def test_walkers_have_the_parameters_of_their_contacts(make_motion, report_of, every, path):
    errors = []
    for seed in range(6):
        walk = make_motion(seed=seed, path=Circle(4.0, left=bool(seed % 2)) if seed > 2 else None)
        options = {} if path else {"path": None}
        report = report_of(walk, every, **options)
        errors.append(gait_errors(report, true_strides(world_feet(walk), 120.0)))
    check(errors)


@pytest.mark.shared
@pytest.mark.parametrize(("kind", "rate", "part"), [("snu", 30, 2), ("cmu", 120, 2)])
def test_real_walks_have_the_parameters_of_their_contacts(
    shared_mocap, kind, rate, part, report_of
):
    errors = {15: [], 30: []}
    folder = MotionFolder(shared_mocap / kind, frames_per_second=rate)
    for file in folder.files()[::part]:
        take = folder.captured(file)
        truth = true_strides(source_feet(take.source), rate)
        if len(truth) >= 4:
            walk = Motion(file.stem, kind, rate, take.angles, take.root_position)
            for wanted, own in errors.items():
                own.append(gait_errors(report_of(walk, rate // wanted), truth))
    for own in errors.values():
        assert len(own) >= 6
        check(own)


def test_walking_backwards_is_said(straight, straight_report, report_of):
    back = replace(
        straight, angles=straight.angles[::-1], root_position=straight.root_position[::-1]
    )
    for options in ({}, {"path": None}):
        report = report_of(back, 4, **options)
        assert report.direction == "backward"
        assert "backwards" in report.notes[0]
        for name in ("cadence", "stride_length"):
            expected = straight_report[name].value
            assert report[name].value == pytest.approx(expected, rel=0.05), name
        assert report["step_width"].value == pytest.approx(
            straight_report["step_width"].value, abs=0.03
        )
    assert straight_report.direction == "forward"


def test_standing_has_no_values_but_a_reason(report_of):
    for rate in (15.0, 30.0):
        x = np.eye(1, 55).repeat(90, axis=0) + np.random.default_rng(0).normal(0, 0.5, (90, 55))
        x[:, :2] = 1.0, 0.0
        report = gait_report(Walk.from_poses(x, frames_per_second=rate, path=np.zeros((90, 3))))
        assert report.direction == "none"
        assert all(np.isnan(p.value) for p in report.parameters)
        assert {p.reason for p in report.parameters} == {"the person stands"}
        assert {c.reason for c in report.curves} == {"the person stands"}


def test_stepping_on_the_spot_is_no_walk(report_of):
    report = report_of(motion("swinging", 90))
    assert np.isnan(report["cadence"].value)
    assert "on the spot" in report["cadence"].reason or "stands" in report["cadence"].reason


def test_too_few_strides_are_said(straight, report_of):
    report = report_of(straight.part(0, 200), 4)
    assert np.isnan(report["stride_time"].value)
    assert report["stride_time"].reason.startswith("too few strides: ")


def test_no_poses_at_all():
    for x in (np.zeros((0, 55)), np.full((30, 55), np.nan)):
        report = gait_report(Walk.from_poses(x, frames_per_second=30.0))
        assert report["speed"].reason == "no frame has a pose"


def test_a_curve_is_noted(make_motion, report_of):
    report = report_of(make_motion(path=Circle(1.5)), 4)
    assert any("curve" in note for note in report.notes)
    assert np.isfinite(report["cadence"].value)


def test_noise_and_lost_frames(straight, straight_report):
    rng = np.random.default_rng(0)
    x = ANGLES.from_angles(straight.angles[::4])
    x[:, 2:] += rng.normal(0, 3.0, x[:, 2:].shape)
    x[rng.random(len(x)) < 0.1] = np.nan
    path = straight.root_position[::4] + rng.normal(0, 0.02, (len(x), 3))
    report = gait_report(Walk.from_poses(x, frames_per_second=30.0, path=path))
    for name, limit in LIMITS.items():
        expected = straight_report[name].value
        assert report[name].value == pytest.approx(expected, rel=limit / 100), name
    assert 0.8 < report["cadence"].confidence < 1.0
    assert any("have no pose" in note for note in report.notes)


def test_there_and_back_counts_one_way(straight, report_of):
    there = straight.part(0, 960)
    both = replace(
        straight,
        angles=np.concatenate([there.angles, there.angles[::-1], there.angles]),
        root_position=np.concatenate(
            [there.root_position, there.root_position[::-1], there.root_position]
        ),
    )
    report = report_of(both, 4)
    assert report.direction == "forward"
    assert any("walking backward" in note for note in report.notes)
    assert not any(stride.backward for stride in report.counted)


def test_running_is_not_walking(straight, report_of):
    fast = replace(straight, frames_per_second=2.2 * straight.frames_per_second)
    report = report_of(fast, 4)
    assert np.isnan(report["cadence"].value)
    assert "too fast" in report["cadence"].reason


def test_parameters_are_found_by_name(straight_report):
    for name in PARAMETERS:
        assert straight_report[name].side == "both"
        assert straight_report[name, "left"].side == "left"
    with pytest.raises(KeyError, match="pace"):
        straight_report["pace"]


def test_least_strides(straight, make_walk):
    assert gait_report(make_walk(straight, 4), least_strides=50)["speed"].reason
    with pytest.raises(InputError, match="least_strides"):
        gait_report(make_walk(straight, 4), least_strides=0)


@settings(max_examples=8, deadline=None)
@given(turn=st.floats(-400, 400), shift=st.floats(-50, 50), scale=st.floats(0.5, 1.5))
def test_the_world_and_the_size_do_not_matter(straight, straight_report, turn, shift, scale):
    theta = np.deg2rad(turn)
    about = np.array(
        [[np.cos(theta), 0, np.sin(theta)], [0, 1, 0], [-np.sin(theta), 0, np.cos(theta)]]
    )
    report = gait_report(
        Walk.from_poses(
            ANGLES.from_angles(straight.angles[::4]),
            frames_per_second=30.0,
            path=scale * straight.root_position[::4] @ about.T + shift,
            camera_azimuth=turn,
            scale=scale,
        )
    )
    assert report["stance"].value == pytest.approx(straight_report["stance"].value, abs=1.5)
    for name, factor in (("cadence", 1), ("speed", scale), ("step_length", scale)):
        expected = factor * straight_report[name].value
        assert report[name].value == pytest.approx(expected, rel=0.02), name

import numpy as np
import pytest
from walk_film import CAMERA, RATE, walk_of

from silpose.core.errors import InputError
from silpose.core.skeleton import POINTS
from silpose.fitting import SHAPES, Fit, standing_body_height
from silpose.model.video import Placement, check_lengths
from silpose.silhouette.video import MaskedFrame


@pytest.fixture(scope="module")
def placement(model):
    return Placement.of(model, (CAMERA.height, CAMERA.width))


def fit_of(x, offset, placement):
    """What a perfect fit would say of a walk."""
    frames = len(x)
    depth = ((offset - CAMERA.position) @ CAMERA.orientation)[:, 2]
    centre = np.array([(CAMERA.width - 1) / 2, (CAMERA.height - 1) / 2])
    view = placement.fitter.view
    scale = (CAMERA.focal_pixels / depth) / (view.focal / view.distance)
    return Fit(
        x, np.zeros((frames, 54, 54)), np.ones(frames), np.ones(frames), ["fitted"] * frames,
        CAMERA.project(offset) - centre, scale, CAMERA.elevation, np.zeros(SHAPES),
        x[:, None], np.ones((frames, 1)), np.zeros((frames, 9)),
    )  # fmt: skip


@pytest.fixture(scope="module")
def truth(body):
    return walk_of(body, 30)


def test_a_perfect_fit_is_placed_where_the_person_was(placement, truth):
    x, offset, _ = truth
    fit = fit_of(x, offset, placement)
    placed = placement.place(fit, RATE)
    moved, true = placed.path - placed.path[0], offset - offset[0]
    np.testing.assert_allclose(moved[:, [0, 2]], true[:, [0, 2]], atol=0.05)
    assert placed.scale == pytest.approx(1.0, abs=1e-6)
    assert placed.camera_height == pytest.approx(0.92 + 4.5 * np.sin(np.deg2rad(5)), abs=0.12)
    assert placed.joints[..., 1].min() == pytest.approx(0.0, abs=0.05)
    toes, ankle = (placed.joints[:, POINTS.index(f"left_{own}")] for own in ("toes", "ankle"))
    assert (toes - ankle)[:, 0].min() > 0.05  # feet point to where the walk goes


def test_a_given_height_makes_everything_larger(model, placement, truth):
    x, offset, _ = truth
    fit, usual = fit_of(x, offset, placement), standing_body_height(placement.fitter, np.zeros(10))
    tall = Placement.of(model, (CAMERA.height, CAMERA.width), body_height=1.2 * usual)
    one, other = placement.place(fit, RATE), tall.place(fit, RATE)
    np.testing.assert_allclose(np.ptp(other.path[:, 0]), 1.2 * np.ptp(one.path[:, 0]))
    np.testing.assert_allclose(other.joints, 1.2 * one.joints, atol=1e-6)
    assert other.scale == pytest.approx(1.2)


def test_frames_without_a_pose_have_no_place(placement, truth):
    fit = fit_of(*truth[:2], placement)
    for values in (fit.x, fit.scale, fit.shift):
        values[7] = np.nan
    placed = placement.place(fit, RATE)
    assert np.isnan(placed.path[7]).all() and np.isfinite(np.delete(placed.path, 7, 0)).all()


def test_a_live_step_has_outline_skeleton_and_place(model, placement, walk):
    stream, mask = model.stream(fit=True), walk.masks[9]
    poses = stream.step(mask)
    frame = MaskedFrame(9, 0.4, np.zeros((*mask.shape, 3), np.uint8), mask, poses.facts)
    step = placement.step(frame, poses, latency=0.01, dropped=2)
    rows, columns = np.nonzero(mask)
    assert abs(step.outline[:, 0].mean() - columns.mean()) < 4
    assert columns.min() - 4 < step.skeleton[0, 0] < columns.max() + 4
    assert rows.min() < step.skeleton[0, 1] < rows.max()
    assert -6 < step.place[2] < -3 and (step.latency, step.dropped) == (0.01, 2)


def test_lengths_of_nobody_are_refused():
    with pytest.raises(InputError, match=r"silhouette\.body_height must be from 0\.5"):
        check_lengths(175, None)
    with pytest.raises(InputError, match=r"silhouette\.focal_length"):
        check_lengths(None, 28)

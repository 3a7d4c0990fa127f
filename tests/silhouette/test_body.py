import numpy as np
import pytest

from silpose.core import skeleton
from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.silhouette import BODIES, LEVELS, Body, Camera, render


def pose(**angles):
    values = np.zeros((1, 54))
    for name, angle in angles.items():
        values[0, skeleton.ANGLES.index(name)] = angle
    return ANGLES.rotations(ANGLES.from_angles(values))


def mask_of(body, rotations):
    (mask,) = render(body, Camera(), rotations)
    return mask


def overlap(a, b):
    return (a & b).sum() / (a | b).sum()


def test_bodies_differ_but_agree_on_the_person():
    rotations = pose(left_hip_x=-20, right_hip_x=15)
    convex = mask_of(Body("convex", level=0), rotations)
    wooden = mask_of(Body("wooden"), rotations)
    assert 0.6 < overlap(convex, wooden) < 1


def test_shape_changes_the_silhouette():
    tall = Body(shape=[3, 0, 0, 0, 0, 0, 0, 0, 0, 0])
    mean, larger = (mask_of(b, pose()) for b in (Body(), tall))
    assert np.ptp(np.nonzero(larger)[0]) != np.ptp(np.nonzero(mean)[0])


@pytest.mark.parametrize(("level", "links"), [(0, 80), (1, 52), (2, 22)])
def test_a_level_of_detail_has_its_number_of_links(level, links):
    assert level in LEVELS
    pieces = Body("convex", level).pieces(pose())
    assert pieces.shape[:2] == (1, links)


@pytest.mark.parametrize("kind", BODIES)
def test_pieces_move_with_their_joints(kind):
    rest, kicked = (Body(kind, level=2).pieces(p)[0] for p in (pose(), pose(left_hip_x=-90)))
    foot = rest[..., 1].min()
    assert foot < -0.9
    assert kicked[kicked[..., 0] > 0.05][:, 2].max() > 0.7  # the left leg points forward
    assert kicked[..., 1].min() == pytest.approx(foot, abs=0.05)  # the right one stands


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"kind": "clay"}, "no body 'clay'"),
        ({"level": 7}, "0, 1 or 2"),
        ({"shape": [1.0]}, "10 coefficients"),
    ],
)
def test_wrong_settings_are_named(settings, message):
    with pytest.raises(InputError, match=message):
        Body(**settings)

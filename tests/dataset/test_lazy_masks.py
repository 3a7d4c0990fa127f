import numpy as np
import pytest
from synthetic import motion

from silpose.core.errors import InputError
from silpose.dataset import LazyMasks, render_take
from silpose.motion import Motion
from silpose.silhouette import Body, Camera

BODY, CAMERA = Body(level=2), Camera(width=48, height=48)


@pytest.fixture(scope="module")
def held_and_lazy():
    one = motion("walk", 20)
    return (render_take(one, BODY, CAMERA, now=now, held=now).masks for now in (True, False))


def test_lazy_masks_are_the_same_as_held_ones(held_and_lazy):
    held, lazy = held_and_lazy
    assert isinstance(held, np.ndarray) and isinstance(lazy, LazyMasks)
    assert len(lazy) == 20
    np.testing.assert_array_equal(np.asarray(lazy), held)
    for frames in (3, -1, np.int64(7), slice(2, None, 5), slice(-3, None)):
        np.testing.assert_array_equal(lazy[frames], held[frames])
    np.testing.assert_array_equal(np.stack(list(lazy.part(slice(4, 6)))), held[4:6])


def test_a_part_is_degraded_by_its_frames_in_the_take():
    frames = []

    def degrade(mask, frame):
        frames.append(int(frame))
        return 1 - mask

    walk = motion("walk", 9)
    masks = render_take(walk, BODY, CAMERA, now=False, held=False, degrade=degrade).masks
    inverted = masks[3:8:2]
    assert frames == [3, 5, 7]
    whole = render_take(walk, BODY, CAMERA).masks
    np.testing.assert_array_equal(inverted, 1 - whole[3:8:2])


def test_a_person_out_of_sight_is_reported():
    walked = np.array([[-9.0, 0, 0], [9.0, 0, 0]])
    far = Motion("far", "p", 15.0, np.zeros((2, 54)), walked)
    with pytest.raises(InputError, match="frame 0 of take 'far' is out of the camera's sight"):
        render_take(far, BODY, Camera(follow=False))
    lazy = render_take(far, BODY, Camera(follow=False), now=False).masks
    with pytest.raises(InputError, match="frame 1 of take 'far'"):
        lazy[1]


def test_those_that_are_held_are_rendered_once_and_only_if_all_are_asked_for():
    frames = []

    def degrade(mask, frame):
        frames.append(int(frame))
        return mask

    masks = render_take(motion("walk", 6), BODY, CAMERA, now=False, degrade=degrade).masks
    assert masks.shape == (6, 48, 48)
    assert masks[2].any() and len(masks[1:3]) == 2
    assert frames == [2, 1, 2]
    frames.clear()
    whole = np.concatenate([masks])
    assert len(list(masks)) == len(masks[::2]) * 2 == 6
    np.testing.assert_array_equal(masks.part(np.array([1, 4])), whole[[1, 4]])
    np.testing.assert_array_equal(masks[4], whole[4])
    assert frames == [*range(6)]

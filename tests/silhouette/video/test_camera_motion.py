import cv2
import numpy as np
import pytest
from video_films import noisy, paint, wall

from silpose.silhouette.video.camera_motion import CameraMotion


def room(seed=0):
    """A scene with fine texture, larger than the pictures."""
    rng = np.random.default_rng(seed)
    return (wall(200, 300) + rng.normal(0, 12, (200, 300, 3))).clip(0, 255)


def view(scene, x, y=20):
    return scene[y : y + 144, x : x + 192]


@pytest.mark.parametrize("light", [1.0, 0.7])
def test_a_person_who_walks_by_is_no_motion_of_the_camera(truth, light):
    rng, motion = np.random.default_rng(1), CameraMotion(0.004)
    scene = view(room(), 10)
    pictures = [noisy((light if k else 1) * paint(scene, truth[k]), rng) for k in range(0, 32, 4)]
    assert not any(motion.step(picture) for picture in pictures)


@pytest.mark.parametrize(("dx", "dy"), [(2, 0), (6, 0), (0, 5), (-4, 3), (70, 30)])
def test_a_camera_that_pans_is_told(truth, dx, dy):
    rng, motion = np.random.default_rng(1), CameraMotion(0.004)
    assert not motion.step(noisy(paint(view(room(), 20), truth[4]), rng))
    assert motion.step(noisy(paint(view(room(), 20 + dx, 20 + dy), truth[8]), rng))


def nearly_plain(x, k=0):
    """A wall whose texture is hardly above the noise, seen from x, with a person's mask."""
    rng = np.random.default_rng(5)
    texture = cv2.GaussianBlur(rng.normal(0, 1, (160, 700)).astype(np.float32), (0, 0), 2)
    seen = 150 + 2 * texture[8:152, x : x + 192] / texture.std()
    return noisy(np.repeat(seen[:, :, None], 3, 2), np.random.default_rng(k))


def test_a_pan_over_a_nearly_plain_wall_is_told_beside_a_person(truth):
    motion, still = CameraMotion(0.004), CameraMotion(0.004)
    for k, x in enumerate(range(10, 210, 20)):
        person = truth[3 * k]
        moved = motion.step(paint(nearly_plain(x, k), person), person)
        assert moved == (k > 0)
        assert not still.step(paint(nearly_plain(10, k), person), person)


def test_a_person_in_noise_who_is_not_known_is_no_motion_of_the_camera(truth):
    motion, rng = CameraMotion(0.004), np.random.default_rng(2)
    pictures = [noisy(paint(wall(), truth[k]), rng, 15) for k in range(0, 32, 2)]
    assert not any(motion.step(picture) for picture in pictures)


def test_a_renewed_reference_forgets_a_bump():
    motion = CameraMotion(0.004, renew=3)
    before, after = (view(room(), x).astype(np.uint8) for x in (20, 30))
    assert [motion.step(p) for p in (before, after, after, after, after)] == [
        False, True, True, False, False,
    ]  # fmt: skip


def test_a_plain_wall_tells_nothing():
    motion = CameraMotion(0.004)
    plain = np.full((144, 192, 3), 128, np.uint8)
    assert not any(motion.step(plain) for _ in range(3))

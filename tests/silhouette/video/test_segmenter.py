import numpy as np
import pytest
from video_films import noisy, overlap, paint, wall

from silpose.silhouette.video import Frame, Segmenter
from silpose.silhouette.video.backgrounds import FixedBackground, Shadows
from silpose.silhouette.video.camera_motion import CameraMotion
from silpose.silhouette.video.followed_person import FollowedPerson


def segmenter(scene=None):
    scene = wall() if scene is None else scene
    return Segmenter(
        FixedBackground(scene.astype(np.uint8), 20, Shadows(0.6, 0.04)),
        CameraMotion(0.004),
        FollowedPerson(None),
        opening=0.004, closing=0.008, smallest=0.001, hole=0.004,
    )  # fmt: skip


def test_a_light_is_switched_on_and_masks_stay(truth):
    rng, own = np.random.default_rng(0), segmenter(0.6 * wall())
    frames = []
    for k in range(20):
        picture = noisy((0.6 if k < 10 else 1.0) * paint(wall(), truth[k]), rng)
        frames.append(own.step(Frame(k, k / 25, picture)))
    assert [frame.state for frame in frames] == ["person"] * 10 + ["switched"] * 3 + ["person"] * 7
    assert min(overlap(f.mask, truth[f.index]) for f in frames) > 0.9


def test_a_camera_that_pans_is_said_once(truth):
    rng = np.random.default_rng(0)
    scene = (wall(160, 300) + rng.normal(0, 12, (160, 300, 3))).clip(0, 255)
    own = segmenter(scene[:144, :192])
    with pytest.warns(UserWarning, match="camera of the stream moves, first seen at") as said:
        states = [
            own.step(Frame(k, k / 25, noisy(scene[:144, 3 * k : 3 * k + 192], rng))).state
            for k in range(20)
        ]
    assert len(said) == 1
    assert states[-1] == "moved"

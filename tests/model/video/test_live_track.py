import numpy as np

from silpose.model.video import LiveTrack, live_steps
from silpose.silhouette.video import VideoMasks


def test_live_steps_become_a_track(model, walk, fitted):
    live = LiveTrack(model, body_height=1.8)
    for step in live_steps(model, VideoMasks(walk.file), frames_per_second=25.0):
        live.add(step)
    track = live.track
    assert len(live) == len(track) == 22 and track.height_given
    both = track.poses.known & fitted.track.poses.known & np.isfinite(track.path[:, 0])
    assert both.sum() > 8
    off = np.linalg.norm(track.joints[both] / 1.8 - fitted.track.joints[both] / 1.72, axis=-1)
    assert np.median(off) < 0.25
    assert track.covariance is None and set(track.seen) == set(fitted.track.seen)

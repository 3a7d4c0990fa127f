import numpy as np
import pytest

from silpose.core.pose_space import wrap_degrees
from silpose.silhouette.video import VideoMasks


def test_a_film_is_fitted_as_a_whole(fitted, walk):
    track = fitted.track
    known = track.poses.known
    assert len(track) == 22 and known.sum() >= 16
    assert not known[0] and track.poses.state[-1] == "blank"
    assert np.nanmedian(track.poses.iou) > 0.75
    frames = np.flatnonzero(known[1:19])
    true, seen = walk.x[frames], track.poses.x[frames + 1]
    off = wrap_degrees(track.poses.space.heading(seen) - track.poses.space.heading(true))
    assert np.median(np.abs(off)) < 25
    moved = track.path[frames[-1] + 1, 0] - track.path[frames[0] + 1, 0]
    assert moved == pytest.approx(np.ptp(walk.offset[frames, 0]), rel=0.2)
    assert track.covariance.shape == (22, 54, 54) and np.isfinite(track.covariance[9]).all()
    assert 1.5 < track.body_height < 1.9 and not track.height_given


def test_steps_show_pictures_only_where_they_are_read_again(fitted, walk):
    alone = list(fitted.steps())
    assert [step.index for step in alone] == list(range(22))
    assert all(step.picture is None for step in alone)
    source = VideoMasks(walk.file)
    shown = list(fitted.steps(source.frames))
    assert shown[9].picture.shape == (144, 192, 3)
    assert len(shown[9].outline) > 10 and np.isfinite(shown[9].skeleton).all()
    assert len(shown[-1].outline) == 0 and np.isnan(shown[-1].place).all()

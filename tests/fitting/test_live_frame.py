import numpy as np
import pytest

from silpose.fitting.live_frame import End, Seen
from silpose.fitting.working_size import WorkingSize
from silpose.silhouette import Camera

SIZE = WorkingSize.for_person(Camera(width=160, height=160), 193.0)


def test_what_is_not_known_of_a_frame_is_none_or_the_origin(walk, estimated):
    seen = Seen.of(walk[1][0], None, None, SIZE)
    assert seen.estimate is None and not seen.root.any()
    assert Seen.of(walk[1][0], np.full(55, np.nan), None, SIZE).estimate is None
    seen = Seen.of(walk[1][0], estimated[0], [0.1, 0.2, 0.3], SIZE)
    assert seen.estimate.shape == (54,) and seen.root[1] == 0.2
    assert len(seen.contour.pixels) > 100


def test_only_what_is_new_makes_a_pose_more_certain():
    before, estimate, contour = (k * np.eye(54) for k in (100.0, 40.0, 60.0))
    end = End(np.zeros(54), before + estimate + contour, before + estimate, 0.0, 0.9, anew=False)
    certain = 1 / end.covariance(before, 0.5, 0.25)[0, 0]
    assert certain == pytest.approx(100 + 0.25 * 40 + 0.5 * 60)
    assert 1 / end.covariance(None, 0.5, 0.25)[0, 0] == pytest.approx(200)
    assert 1 / end._replace(anew=True).covariance(before, 0.5, 0.25)[0, 0] == pytest.approx(200)

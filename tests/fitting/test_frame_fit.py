import numpy as np
import pytest

from silpose.core.pose_space import ANGLES as SPACE
from silpose.fitting.contour import contour_of
from silpose.fitting.frame_fit import Gaussian, fit_frame, fit_starts
from silpose.fitting.geometry import geometry_of
from silpose.fitting.likelihood import Observation
from silpose.fitting.matching import Matching


@pytest.fixture
def frame(body, view, walk, estimated, prior):
    """Estimated angles of a frame, its prior and its observation."""
    angles = np.deg2rad(SPACE.angles(estimated[0]))
    seen = Observation(contour_of(walk[1][0]), np.zeros(3), geometry_of(body), view, Matching())
    return angles, (Gaussian(angles, prior.precision), seen)


def test_a_fit_may_be_interrupted(frame):
    angles, of = frame
    through, _, cost, _ = fit_frame(angles, *of, 6, 0)
    half, *_ = fit_frame(angles, *of, 3, 0)
    again, _, same, _ = fit_frame(half, *of, 6, 3)
    np.testing.assert_allclose(again, through)
    assert same == pytest.approx(cost)


def test_starts_that_lead_nowhere_are_given_up(frame):
    angles, of = frame
    turned = angles.copy()
    turned[0] += np.pi / 2
    starts = np.stack([turned, angles, angles + 1e-4])
    ends, _, costs = fit_starts(starts, *of, 8, np.inf)
    assert np.isnan(costs[0]) and np.isfinite(costs[1:]).sum() == 1
    best = int(np.nanargmin(costs))
    np.testing.assert_allclose(ends[best], fit_frame(starts[best], *of, 8, 0)[0])
    assert np.isnan(fit_starts(starts, *of, 8, costs[best] - 200)[2]).all()

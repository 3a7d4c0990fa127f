import numpy as np
import pytest
from scipy.stats import t
from synthetic import swinging

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.fitting import PosePrior
from silpose.fitting.prior import news


def test_the_covariance_is_that_of_the_errors():
    rng = np.random.default_rng(0)
    true = [ANGLES.from_angles(swinging(400, seed)) for seed in range(3)]
    spread = rng.uniform(1, 10, 54)
    wrong = [ANGLES.from_angles(ANGLES.angles(x) + rng.normal(0, spread, (400, 54))) for x in true]
    prior = PosePrior.from_errors(true, wrong, 15.0)
    assert np.sqrt(np.diag(prior.covariance)) == pytest.approx(np.sqrt(spread**2 + 0.49), rel=0.1)


def test_few_performers_tell_less_of_another_one():
    rng = np.random.default_rng(0)
    true = [ANGLES.from_angles(swinging(40, seed)) for seed in range(8)]
    wrong = [ANGLES.from_angles(ANGLES.angles(x) + rng.normal(0, 5, (40, 54))) for x in true]
    traces = [
        np.trace(PosePrior.from_errors(true, wrong, 15.0, performers=list(names)).covariance)
        for names in ("abcdefgh", "aabbccdd", "aaaaaaaa")
    ]
    assert traces[1] / traces[0] == pytest.approx((t.ppf(0.95, 4) / t.ppf(0.95, 8)) ** 2, rel=0.01)
    assert traces[0] < traces[1] < traces[2]
    assert np.trace(PosePrior.from_errors(true, wrong, 15.0).covariance) < traces[0]


def test_frames_seen_from_the_wrong_side_tell_nothing():
    rng = np.random.default_rng(0)
    x = ANGLES.from_angles(swinging(200))
    errors = rng.normal(0, 3, (200, 54))
    errors[::4, 0] = 180
    prior = PosePrior.from_errors([x], [ANGLES.from_angles(ANGLES.angles(x) + errors)], 15.0)
    assert prior.covariance[0, 0] < 20


def test_too_few_frames_are_refused():
    x = ANGLES.from_angles(swinging(20))
    with pytest.raises(InputError, match="54 held-out frames"):
        PosePrior.from_errors([x], [x], 15.0)


@pytest.mark.parametrize("wrong", [{"lasting": 1.0}, {"lasting": -0.1}, {"seconds": 0.0}])
def test_impossible_times_are_refused(wrong):
    with pytest.raises(InputError, match="lasts for a share below 1"):
        PosePrior(np.eye(54), np.eye(54), **wrong)


def test_what_is_new_in_a_frame_grows_with_the_time_since_the_last():
    shares = [news(step, 0.15) for step in (1e-3, 1 / 60, 1 / 15, 1.0, 10.0)]
    assert shares == sorted(shares) and 0 < shares[0] < 0.01 and shares[-1] > 0.99

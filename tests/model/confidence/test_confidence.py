import numpy as np
import pytest

from silpose.model.confidence import Confidence
from silpose.model.confidence.confidence import UNSEEN, UPSIDE_DOWN
from silpose.model.confidence.odd_frames import facts_of


@pytest.fixture(scope="module")
def judged(small):
    """Descriptors, estimates, facts and confidence of the test take."""
    (z, _), (take,) = small.described.test[0], small.described.data.test
    x, facts = small.regressor.predict(z), facts_of(list(take.masks))[1]
    return z, x, facts, small.confidence.of(z, x, facts)


def test_clean_frames_are_hardly_doubtful(judged):
    confidence = judged[-1]
    assert confidence.shape == (60,)
    assert confidence.min() >= 0 and confidence.max() <= 1
    assert np.mean(confidence < 0.5) <= 0.05


def test_the_opposite_heading_is_doubtful(small, judged):
    z, x, facts, _ = judged
    turned = x.copy()
    turned[:, :2] *= -1
    assert (small.confidence.of(z, turned, facts) < 0.5).mean() > 0.9


def test_noise_is_doubtful(small, judged):
    z, _, facts, _ = judged
    noise = np.random.default_rng(0).dirichlet(np.full(z.shape[1], 0.3), len(z))
    estimated = small.regressor.predict(noise)
    assert (small.confidence.of(noise, estimated, facts) < 0.5).all()


def test_one_frame_is_judged_as_among_others(small, judged):
    z, x, facts, confidence = judged
    alone = [small.confidence.of(z[f : f + 1], x[f : f + 1], facts[f : f + 1])[0] for f in range(5)]
    np.testing.assert_allclose(alone, confidence[:5], rtol=1e-3, atol=1e-3)


def test_frames_without_a_pose_or_a_person(small, judged):
    z, x, facts, confidence = judged
    z, x = z.copy(), x.copy()
    z[2], x[4] = np.nan, np.nan
    own = small.confidence.of(z, x, facts)
    assert own[2] == UNSEEN < 0.5
    assert own[4] == 0
    kept = np.delete(np.arange(60), [2, 4])
    np.testing.assert_allclose(own[kept], confidence[kept], rtol=1e-3, atol=1e-3)
    nothing = np.full_like(x, np.nan)
    assert (small.confidence.of(z, nothing, facts) == 0).all()


def test_descriptors_alone_can_be_judged(small, judged):
    z, x, *_ = judged
    assert np.isfinite(small.confidence.of(z, x)).all()


def test_restored_from_arrays(small, judged):
    z, x, facts, confidence = judged
    other = Confidence.from_arrays(small.confidence.to_arrays())
    np.testing.assert_array_equal(other.of(z, x, facts), confidence)


def test_a_single_mask_upside_down_is_doubtful(small):
    (take,) = small.described.data.test
    descriptor = small.described.descriptor
    for turned in (take.masks[:, ::-1], take.masks[:, ::-1, ::-1]):
        masks, facts = facts_of(list(np.ascontiguousarray(turned)))
        z = descriptor.transform(masks)
        confidence = [
            small.confidence.of(z[f : f + 1], take.x[f : f + 1], facts[f : f + 1])
            for f in range(0, 60, 7)
        ]
        assert np.max(confidence) <= UPSIDE_DOWN < 0.5

import numpy as np

from silpose.fitting import BodyFitter, Confidence


def test_every_frame_has_a_state_and_a_confidence(body, camera, prior, walk, estimated):
    masks = [mask * (frame != 2) for frame, mask in enumerate(walk[1][:5])]
    fit = BodyFitter(body, camera, prior).fit(masks, estimated[:5])
    assert fit.state == ["fitted", "fitted", "blank", "fitted", "fitted"]
    assert fit.confidence[2] == 0 and np.isnan(fit.evidence[2]).all()
    assert ((fit.confidence >= 0) & (fit.confidence <= 1)).all()
    assert (np.delete(fit.confidence, 2) > 0.8).all()


def test_below_a_half_a_fit_is_poor(body, camera, prior, walk, estimated):
    doubting = Confidence((-50.0,) + (0.0,) * (len(Confidence().weights) - 1))
    fit = BodyFitter(body, camera, prior, confidence=doubting).fit(walk[1][:3], estimated[:3])
    assert set(fit.state) == {"poor"} and fit.confidence.max() < 1e-6
    assert np.isfinite(fit.x).all()

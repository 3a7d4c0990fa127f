import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.fitting import BodyFitter, fitted_silhouettes, overlap, overlap_classes, trace_frame


@pytest.fixture(scope="module")
def fitter(body, camera, prior):
    return BodyFitter(body, camera, prior, iterations=6)


def test_a_frame_converges(fitter, walk, estimated):
    x, masks = walk
    trace = trace_frame(fitter, masks[3], estimated[3])
    assert len(trace.x) == len(trace.iou) == len(trace.cost) == len(trace.silhouettes) == 7
    assert ANGLES.distance(trace.x[0], estimated[3]) == pytest.approx(0, abs=1e-6)
    assert trace.cost[-1] < trace.cost[0]
    assert trace.iou[-1] > max(0.95, trace.iou[0])
    assert ANGLES.distance(trace.x[-1], x[3]) < ANGLES.distance(trace.x[0], x[3])


def test_it_ends_where_the_frame_by_itself_is_fitted(fitter, body, camera, prior, walk, estimated):
    _, masks = walk
    alone = BodyFitter(body, camera, prior, iterations=6, whole_take=False)
    fit = alone.fit(masks[3:4], estimated[3:4])
    trace = trace_frame(fitter, masks[3], estimated[3])
    assert trace.x[-1] == pytest.approx(fit.x[0])
    assert trace.iou[-1] == pytest.approx(fit.iou[0])


def test_silhouettes_are_those_whose_overlap_was_measured(fitter, walk, estimated):
    for knowledge in ("known", "estimated"):
        own = BodyFitter(
            fitter.body, fitter.camera, fitter.prior, camera_is=knowledge, shape_is=knowledge
        )
        masks = [*walk[1][:3], np.zeros_like(walk[1][0])]
        fit = own.fit(masks, estimated[:4])
        filled = fitted_silhouettes(own, fit)
        shares = [overlap(*pair) for pair in zip(filled, masks, strict=True)]
        assert shares[:3] == pytest.approx(fit.iou[:3], abs=1e-9)
        assert not filled[3].any()


def test_an_overlap_tells_which_of_the_two_is_where():
    mask, body = np.array([[0, 1, 1, 0]], np.uint8), np.array([[0, 1, 0, 1]], np.uint8)
    assert overlap_classes(mask, body).tolist() == [[0, 1, 2, 3]]


def test_a_blank_mask_has_no_trace(fitter, walk, estimated):
    with pytest.raises(InputError, match="person"):
        trace_frame(fitter, np.zeros_like(walk[1][0]), estimated[0])

import numpy as np
import pytest

from silpose.core.pose_space import ANGLES as SPACE
from silpose.fitting.contour import contour_of
from silpose.fitting.evidence import EVIDENCE, Fitted, evidence_of
from silpose.fitting.geometry import geometry_of
from silpose.fitting.likelihood import Observation
from silpose.fitting.matching import Matching
from silpose.fitting.parameters import PARAMETERS


@pytest.fixture
def evidence(body, view, walk, prior):
    """Evidence of a pose of the walk, by name, beside an estimate that differs."""
    errors = np.linalg.inv(np.deg2rad(np.deg2rad(prior.covariance[1:, 1:])))
    true = np.deg2rad(SPACE.angles(walk[0][0]))

    def of(parameters=true, estimate=true, iou=0.95, turning=100.0, spread=0.01):
        fitted = Fitted(parameters, spread * np.eye(54), iou, turning)
        seen = Observation(contour_of(walk[1][0]), np.zeros(3), geometry_of(body), view, Matching())
        values = evidence_of(fitted, estimate, errors, seen)
        assert np.isfinite(values).all()
        return dict(zip(EVIDENCE, values, strict=True))

    of.true = true
    return of


def test_a_pose_that_explains_its_mask_speaks_for_itself(evidence):
    of = evidence()
    assert of["misfit"] < 0.2
    assert of["deviation"] == of["turned"] == of["shape"] == of["free"] == 0
    assert of["turning"] > 0.9


def test_each_kind_of_fault_shows(evidence):
    turned = evidence.true + np.pi * (np.arange(54) == 0)
    bent = evidence.true + 0.5 * (np.arange(54) > 0)
    assert evidence(estimate=turned)["turned"] == pytest.approx(1)
    assert evidence(estimate=turned)["deviation"] == pytest.approx(0, abs=1e-6)
    assert evidence(estimate=bent)["deviation"] > 3
    assert evidence(bent)["misfit"] > evidence()["misfit"]
    assert evidence(iou=0.5)["unexplained"] > evidence()["unexplained"]
    assert evidence(spread=0.1)["heading_spread"] > evidence()["heading_spread"]
    assert evidence(spread=0.1)["joint_spread"] > evidence()["joint_spread"]
    assert evidence(turning=-100.0)["turning"] < -0.9


def test_a_strange_shape_shows_where_it_is_free(evidence):
    free = np.zeros(PARAMETERS)
    free[:54], free[-10:] = evidence.true, 2.0
    of = evidence(free)
    assert of["shape"] == pytest.approx(4) and of["free"] == 1


def test_out_of_sight_evidence_is_finite(evidence):
    away = np.zeros(PARAMETERS)
    away[:54], away[54] = evidence.true, 1e5
    assert evidence(away, iou=0.0)["misfit"] >= 1

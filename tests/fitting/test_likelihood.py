import numpy as np
import pytest

from silpose.core.pose_space import ANGLES as SPACE
from silpose.fitting.contour import contour_of
from silpose.fitting.geometry import geometry_of
from silpose.fitting.likelihood import Observation, add_evidence, misfit_of
from silpose.fitting.matching import Matching
from silpose.fitting.overlap import projected_links
from silpose.fitting.parameters import PARAMETERS


def evidence(parameters, contour, geometry, view):
    size = len(parameters)
    hessian, gradient = np.zeros((size, size)), np.zeros(size)
    seen = Observation(contour, np.zeros(3), geometry, view, Matching())
    misfit = add_evidence(parameters, seen, hessian, gradient)
    return misfit, hessian, gradient


def parameters_of(pose):
    parameters = np.zeros(PARAMETERS)
    parameters[:54] = np.deg2rad(SPACE.angles(pose))
    return parameters


def test_the_true_pose_explains_its_mask_best(body, walk, view):
    x, masks = walk
    geometry, contour = geometry_of(body), contour_of(masks[0])
    true = evidence(parameters_of(x[0]), contour, geometry, view)[0]
    for off in np.random.default_rng(0).normal(0, 0.1, (10, 54)):
        moved = parameters_of(x[0])
        moved[:54] += off
        assert evidence(moved, contour, geometry, view)[0] > true


def test_misfit_alone_is_that_of_the_evidence(body, walk, view):
    x, masks = walk
    geometry, contour = geometry_of(body), contour_of(masks[1])
    parameters = parameters_of(x[0])
    alone = misfit_of(parameters, Observation(contour, np.zeros(3), geometry, view, Matching()))
    assert alone == pytest.approx(evidence(parameters, contour, geometry, view)[0])


@pytest.mark.parametrize("count", [54, 57])
def test_parameters_that_are_known_change_nothing_of_the_others(body, walk, view, count):
    geometry, contour = geometry_of(body), contour_of(walk[1][0])
    every = parameters_of(walk[0][1])
    misfit, hessian, gradient = evidence(every, contour, geometry, view)
    fewer = evidence(every[:count].copy(), contour, geometry, view)
    assert fewer[0] == pytest.approx(misfit)
    np.testing.assert_allclose(fewer[1], hessian[:count, :count], atol=1e-6)
    np.testing.assert_allclose(fewer[2], gradient[:count], atol=1e-6)


@pytest.mark.parametrize("parameter", [0, 1, 4, 40, 54, 55, 56, 57, 58, 59])
def test_a_step_along_the_gradient_of_one_parameter_undoes_a_change_of_it(
    body, walk, view, parameter
):
    """Residuals of a small change are J times it: solving for it alone gives it back."""
    x, masks = walk
    geometry = geometry_of(body)
    true = parameters_of(x[0])
    change = 4.0 if parameter in (54, 55) else 1.0 if parameter >= 58 else 0.04
    moved = true.copy()
    moved[parameter] -= change
    _, hessian, gradient = evidence(moved, contour_of(masks[0]), geometry, view)
    found = gradient[parameter] / hessian[parameter, parameter]
    assert found == pytest.approx(change, rel=0.5)


def test_angles_alone_give_the_same_as_all_parameters(body, walk, view):
    x, masks = walk
    geometry, contour = geometry_of(body), contour_of(masks[2])
    every = evidence(parameters_of(x[0]), contour, geometry, view)
    angles = evidence(parameters_of(x[0])[:54], contour, geometry, view)
    assert angles[0] == pytest.approx(every[0])
    assert angles[1] == pytest.approx(every[1][:54, :54])


def test_an_outlier_pulls_little(body, walk, view):
    x, masks = walk
    geometry, contour = geometry_of(body), contour_of(masks[0])
    far = contour._replace(
        pixels=np.vstack([contour.pixels, [[5.0, 5.0]]]),
        normals=np.vstack([contour.normals, [[1.0, 0.0]]]),
    )
    parameters = parameters_of(x[0])
    plain = evidence(parameters, contour, geometry, view)
    pulled = evidence(parameters, far, geometry, view)
    step = np.linalg.solve(plain[1] + 10 * np.eye(PARAMETERS), pulled[2] - plain[2])
    assert np.abs(step[:54]).max() < np.deg2rad(2)


def test_links_project_as_the_camera_does(body, camera, walk, view):
    x, _ = walk
    flat = projected_links(parameters_of(x[3]), np.zeros(3), geometry_of(body), view)
    pieces = camera.project(body.pieces(SPACE.rotations(x[3:4])).astype(float))[0]
    assert flat == pytest.approx(pieces, abs=0.01)

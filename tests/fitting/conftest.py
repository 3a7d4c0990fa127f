"""A body, a camera, a walk of known poses, and how estimates of it err."""

import numpy as np
import pytest
from synthetic import swinging

from silpose.core.pose_space import ANGLES
from silpose.fitting import BodyFitter, PosePrior
from silpose.silhouette import Body, Camera, render


@pytest.fixture(scope="session")
def body():
    return Body("convex", level=2)


@pytest.fixture(scope="session")
def camera():
    return Camera(width=160, height=160)


@pytest.fixture(scope="session")
def walk(body, camera):
    """True poses (12, 55) and their masks."""
    x = ANGLES.from_angles(swinging(12, turns=0.2))
    return x, list(render(body, camera, ANGLES.rotations(x)))


@pytest.fixture(scope="session")
def estimated(walk):
    """Poses (12, 55) that err by a few degrees in every angle."""
    x, _ = walk
    errors = np.random.default_rng(1).normal(0, 5, (len(x), 54))
    return ANGLES.from_angles(ANGLES.angles(x) + errors)


@pytest.fixture(scope="session")
def prior():
    rng = np.random.default_rng(2)
    true = [ANGLES.from_angles(swinging(60, seed)) for seed in range(3)]
    wrong = [ANGLES.from_angles(ANGLES.angles(x) + rng.normal(0, 5, (60, 54))) for x in true]
    return PosePrior.from_errors(true, wrong, 15.0)


@pytest.fixture(scope="session")
def view(body, camera, prior):
    """The camera as the fit sees it."""
    return BodyFitter(body, camera, prior).view

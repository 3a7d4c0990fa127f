from types import SimpleNamespace

import pytest
from synthetic import motion

from silpose.core.pose_space import ANGLES
from silpose.dataset import Dataset, render_take
from silpose.descriptor import ShapeContextHistogram
from silpose.model import describe_dataset
from silpose.model.confidence import train_confidence
from silpose.regression import Basis, RidgeRegressor


@pytest.fixture(scope="package")
def small(body, camera):
    """A small described dataset, a regressor, and the confidence in it."""
    takes = [render_take(motion(f"take{k}", 60, seed=k), body, camera) for k in range(7)]
    data = Dataset("small", ANGLES, takes[:6], [], takes[6:])
    described = describe_dataset(data, ShapeContextHistogram(codebook_size=40))
    regressor = RidgeRegressor(Basis(width=2), damping=0.1).fit(*described.joined("train"))
    confidence = train_confidence(described, regressor)
    return SimpleNamespace(described=described, regressor=regressor, confidence=confidence)

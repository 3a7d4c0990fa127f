"""A small model, and a small tree of takes."""

import cv2
import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.descriptor import ShapeContextHistogram
from silpose.model import PoseModel
from silpose.regression import RidgeRegressor


@pytest.fixture(scope="session")
def small_model(sequence):
    histogram = ShapeContextHistogram(codebook_size=20)
    return PoseModel(histogram, RidgeRegressor(damping=0.1), ANGLES, 15.0).fit(
        sequence.masks, sequence.x
    )


@pytest.fixture
def tree(tmp_path, sequence):
    """Three takes of five masks; of the second one is blank, and one file is no image."""
    root = tmp_path / "root"
    for k, name in enumerate(("001/nm-01/090", "001/nm-02/090", "002/nm-01/090")):
        (root / name).mkdir(parents=True)
        for frame in range(5):
            mask = 255 * sequence.masks[5 * k + frame] * np.uint8((k, frame) != (1, 2))
            cv2.imwrite(str(root / name / f"{frame:03d}.png"), mask)
    return root

"""A model that tracks and fits, trained on one short take."""

import numpy as np

from silpose.core.pose_space import ANGLES
from silpose.descriptor import ShapeContextHistogram
from silpose.fitting import BodyFitter, Confidence, PosePrior
from silpose.model import PoseFitter, PoseModel
from silpose.regression import RidgeRegressor
from silpose.tracking import BeliefTracker


def tracking_and_fitting(sequence, body, camera):
    """Train on a take of that body, seen by that camera."""
    histogram = ShapeContextHistogram(codebook_size=30)
    z = histogram.fit_transform(sequence.masks)
    prior = PosePrior(25.0 * np.eye(54), 2e4 * np.eye(54))
    usual = Confidence(usual_iou=0.9)
    fitter = PoseFitter(BodyFitter(body, camera, prior, confidence=usual), z, sequence.x, 2)
    tracker = BeliefTracker(keep=0.5).fit([(z, sequence.x)])
    regressor = RidgeRegressor(damping=0.01).fit(z, sequence.x)
    return PoseModel(histogram, regressor, ANGLES, 15.0, tracker, fitter)

"""How long a live step takes, from mask to pose: python benchmarks/tracking.py."""

from time import perf_counter

import cv2
import numpy as np
from threadpoolctl import threadpool_limits
from timing import report

from silpose.app.config import build_components, load
from silpose.model.describe import examples, learn_descriptor
from silpose.model.pose_model import PoseModel
from silpose.regression import Basis, MixtureOfRegressors, RidgeRegressor
from silpose.tracking import BeliefTracker, MultipleHypothesisTracker

if __name__ == "__main__":
    rooms = build_components(load(["descriptor.n_jobs=1"]))
    data = rooms.dataset()
    descriptor = learn_descriptor(rooms.descriptor, data.train)
    train = examples(descriptor, data.train)
    frames = sum(len(x) for _, x in train)
    ridge = RidgeRegressor(Basis(hellinger=True, width=4.0))
    mixture = MixtureOfRegressors(120, hellinger=True, units=data.space.units, shared=ridge)
    trackers = {
        "belief": BeliefTracker(pose_width=0.7, descriptor_width=0.8, damping=4.0),
        "hypotheses": MultipleHypothesisTracker(mixture),
    }
    cv2.setNumThreads(1)
    rows = []
    with threadpool_limits(1):
        for name, tracker in trackers.items():
            started = perf_counter()
            tracker.fit(train)
            fitted = perf_counter() - started
            model = PoseModel(descriptor, RidgeRegressor(), data.space, 15.0, tracker)
            took = []
            step = model.stream()
            for mask in [*data.test[0].masks] * 3:
                started = perf_counter()
                step(mask)
                took.append(1000 * (perf_counter() - started))
            rows += [
                [f"{name}: fitting to {frames} frames", f"{1000 * fitted:,.0f}"],
                [f"{name}: step, median", f"{np.median(took):.2f}"],
                [f"{name}: step, 99th percentile", f"{np.quantile(took, 0.99):.2f}"],
                [f"{name}: step, longest", f"{max(took):.2f}"],
            ]
    report(f"{len(took)} masks of 256 x 256 to poses, one core", ["what", "milliseconds"], rows)

"""How long a live step takes, from mask to pose: python benchmarks/tracking.py [--fast].

Trackers are fitted to motion of walkers; with ``--fast``, to few seconds of it.
"""

from time import perf_counter

import cv2
import numpy as np
from threadpoolctl import threadpool_limits
from timing import FAST, report

from silpose.dataset import Renderer, SamePerformer
from silpose.descriptor import ShapeContextHistogram
from silpose.model import describe_dataset
from silpose.motion import WalkerTakes
from silpose.regression import Basis, MixtureOfRegressors, RidgeRegressor
from silpose.tracking import BeliefTracker, MultipleHypothesisTracker, SinglePoseTracker

if __name__ == "__main__":
    walkers = WalkerTakes(seconds=3, test_seconds=3) if FAST else WalkerTakes()
    descriptor = ShapeContextHistogram(codebook_size=40) if FAST else ShapeContextHistogram()
    described = describe_dataset(SamePerformer().load(Renderer(walkers)), descriptor)
    train, space = described.train, described.data.space
    frames = sum(len(x) for _, x in train)
    ridge = RidgeRegressor(Basis(width=4.0))
    mixture = MixtureOfRegressors(20 if FAST else 120, units=space.units, shared=ridge)
    trackers = {
        "belief": BeliefTracker(pose_width=0.7, descriptor_width=0.8, damping=4.0),
        "hypotheses": MultipleHypothesisTracker(mixture),
        "single pose": SinglePoseTracker(),
    }
    masks = [*described.data.test[0].masks] * (1 if FAST else 3)
    known = described.test[0][1][:2]
    cv2.setNumThreads(1)
    rows = []
    with threadpool_limits(1):
        for name, tracker in trackers.items():
            started = perf_counter()
            tracker.fit(train)
            fitted = perf_counter() - started
            stream = tracker.start(known)
            took = []
            for mask in masks:
                started = perf_counter()
                stream.step(described.descriptor.transform([mask])[0])
                took.append(1000 * (perf_counter() - started))
            rows += [
                [f"{name}: fitting to {frames} frames", f"{1000 * fitted:,.0f}"],
                [f"{name}: step, median", f"{np.median(took):.2f}"],
                [f"{name}: step, 99th percentile", f"{np.quantile(took, 0.99):.2f}"],
                [f"{name}: step, longest", f"{max(took):.2f}"],
            ]
    size = "x".join(map(str, masks[0].shape))
    report(f"{len(took)} masks of {size} to poses, one core", ["what", "milliseconds"], rows)

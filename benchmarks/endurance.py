"""A tracker and live frames without end: python benchmarks/endurance.py [STEPS] [FRAMES] [--fast].

The tracker takes a million steps over random descriptors; frames of a walker go from the picture to
a fitted pose and into a recording of masks, a hundred thousand of them, which is an hour. Estimates
must stay finite, and memory must not grow; otherwise it exits with 1.
"""

import resource
import sys
import tempfile
import tracemalloc
from itertools import cycle, islice
from pathlib import Path

import numpy as np
from timing import FAST, report

from silpose.core.pose_space import ANGLES
from silpose.dataset import Renderer, SamePerformer
from silpose.descriptor import ShapeContextHistogram
from silpose.fitting import BodyFitter, Confidence, PosePrior
from silpose.model import PoseFitter, PoseModel, describe_dataset
from silpose.model.video import live_steps
from silpose.motion import WalkerTakes
from silpose.recording import Header, video_recording
from silpose.regression import RidgeRegressor
from silpose.silhouette import Body
from silpose.silhouette.person import PersonSelector
from silpose.silhouette.video import MaskedFrame
from silpose.tracking import BeliefTracker

GROWTH = 100_000  # bytes beyond which memory counts as growing, from one row to the next
LIVE_GROWTH = 60_000_000  # bytes of the process in the second half: rows of ten seconds wait


def track(described, steps):
    """Step over random descriptors; return rows, and whether all is well."""
    stream = BeliefTracker().fit(described.train).start()
    random = np.random.default_rng(0)
    tracemalloc.start()
    rows, all_finite, growth, before = [], True, [], 0
    for tenth in range(1, 11):
        finite = True
        for z in random.dirichlet(np.full(100, 0.1), steps // 10):
            finite &= bool(np.isfinite(stream.step(z)[0]).all())
        now = tracemalloc.get_traced_memory()[0]
        rows.append([f"{tenth * steps // 10:,}", "yes" if finite else "NO", f"{now - before:+,}"])
        growth.append(now - before)
        all_finite &= finite
        before = now
    tracemalloc.stop()
    return rows, all_finite and min(growth[1:]) <= GROWTH


def frames_of(masks):
    """Frames of a camera that sees the same walk again and again."""
    selector = PersonSelector(None)
    for k, mask in enumerate(cycle(masks)):
        alone, facts = selector.step(mask)
        yield MaskedFrame(k, k / 15, np.zeros((*mask.shape, 3), np.uint8), alone, facts)


def live(data, described, frames):
    """Record live steps; return rows, and whether all is well."""
    take = data.test[0]
    z, x = (np.concatenate(part) for part in zip(*described.train, strict=True))
    prior = PosePrior(25.0 * np.eye(54), 2e4 * np.eye(54))
    body = BodyFitter(Body(), take.camera, prior, confidence=Confidence(usual_iou=0.9))
    fitter = PoseFitter(body, z, x, 0)
    ridge = RidgeRegressor(damping=0.1).fit(z, x)
    model = PoseModel(described.descriptor, ridge, ANGLES, 15.0, None, fitter)
    rows, finite, sizes = [], True, []
    with tempfile.TemporaryDirectory() as folder:
        header = Header("video", "endurance", Path(folder) / "run.rrd", "a walk without end")
        size = take.masks[0].shape
        with video_recording(header, size, 15.0, keep_pictures=False, live=True) as recorder:
            steps = live_steps(model, frames_of(take.masks))
            for tenth in range(1, 11):
                for step in islice(steps, frames // 10):
                    finite &= bool(np.isfinite(step.poses.x).all())
                    recorder.log(step)
                sizes.append(1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
                more = sizes[-1] - sizes[max(0, tenth - 2)]
                rows.append([f"{tenth * frames // 10:,}", "yes" if finite else "NO", f"{more:+,}"])
            steps.close()
    return rows, finite and sizes[-1] - sizes[4] <= LIVE_GROWTH


if __name__ == "__main__":
    given = [int(argument) for argument in sys.argv[1:] if argument.isdecimal()]
    count, frames = [*given, *((2_000, 300) if FAST else (1_000_000, 108_000))[len(given) :]]
    walkers = WalkerTakes(seconds=6, test_seconds=2)
    data = SamePerformer().load(Renderer(walkers))
    described = describe_dataset(data, ShapeContextHistogram())
    titles = ["finite", "bytes since the row above"]
    rows, well = track(described, count)
    report("random descriptors", ["steps", *titles], rows)
    rows, live_well = live(data, described, frames)
    report("live frames", ["frames", *titles], rows)
    if not (well and live_well):
        sys.exit("estimates are not finite, or memory grows")

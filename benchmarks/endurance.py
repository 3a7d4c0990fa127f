"""A million steps over random descriptors: python benchmarks/endurance.py [STEPS] [--fast].

The tracker's estimates must stay finite, and its memory must not grow; otherwise it exits with 1.
"""

import sys
import tracemalloc

import numpy as np
from timing import FAST, report

from silpose.dataset import Renderer, SamePerformer
from silpose.descriptor import ShapeContextHistogram
from silpose.model import describe_dataset
from silpose.motion import WalkerTakes
from silpose.tracking import BeliefTracker

GROWTH = 100_000  # bytes beyond which memory counts as growing, from one row to the next

if __name__ == "__main__":
    given = [int(argument) for argument in sys.argv[1:] if argument.isdecimal()]
    steps = given[0] if given else 2_000 if FAST else 1_000_000
    walkers = WalkerTakes(seconds=6, test_seconds=2)
    described = describe_dataset(SamePerformer().load(Renderer(walkers)), ShapeContextHistogram())
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
    report("random descriptors", ["steps", "finite", "bytes since the row above"], rows)
    if not all_finite or min(growth[1:]) > GROWTH:
        sys.exit("the tracker's estimates are not finite, or its memory grows")

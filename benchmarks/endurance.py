"""A million steps of random descriptors: python benchmarks/endurance.py [STEPS].

The tracker's answers must stay finite, and its memory flat.
"""

import sys
import tracemalloc

import numpy as np
from timing import report

from silpose.app.config import build_components, load
from silpose.model.describe import examples, learn_descriptor
from silpose.tracking import BeliefTracker

if __name__ == "__main__":
    steps = int(sys.argv[1]) if len(sys.argv) > 1 else 1_000_000
    rooms = build_components(load(["motion.seconds=6"]))
    data = rooms.dataset()
    train = examples(learn_descriptor(rooms.descriptor, data.train), data.train)
    tracker = BeliefTracker().fit(train)
    random = np.random.default_rng(0)
    tracemalloc.start()
    rows, before = [], 0
    for tenth in range(1, 11):
        finite = True
        for z in random.dirichlet(np.full(100, 0.1), steps // 10):
            finite &= bool(np.isfinite(tracker.step(z)[0]).all())
        now = tracemalloc.get_traced_memory()[0]
        rows.append([f"{tenth * steps // 10:,}", "yes" if finite else "NO", f"{now - before:+,}"])
        before = now
    report("random descriptors", ["steps", "finite", "bytes since the row above"], rows)

"""Training data made per second, and the memory needed: python benchmarks/factory.py [FRAMES].

Motion of walkers, another body and another camera for every take, all cores; with ``--fast``, few
frames.
"""

import resource
import sys
from dataclasses import replace
from time import perf_counter

from timing import FAST, report

from silpose.dataset import Renderer, SamePerformer, SceneSampler
from silpose.descriptor import ShapeContextHistogram
from silpose.model import describe_dataset
from silpose.motion import WalkerTakes

WIDE = SceneSampler(
    around=True,
    elevation=[-5, 25],
    focal_length=[1.5, 2.2],
    distance=[4.4, 6.5],
    shape=[0, 3],
)
"""Ranges that bodies and cameras are drawn from, as silhouette/scenes=wide."""

if __name__ == "__main__":
    given = [int(argument) for argument in sys.argv[1:] if argument.isdecimal()]
    frames = given[0] if given else 1000 if FAST else 100_000
    walkers = WalkerTakes(test_seconds=2) if FAST else WalkerTakes()
    started = perf_counter()
    data = SamePerformer().load(Renderer(walkers, scenes=replace(WIDE, frames=frames)))
    described = describe_dataset(data, ShapeContextHistogram())
    took = perf_counter() - started
    made = sum(len(z) for z, _ in described.train)
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024  # KiB on Linux
    report(
        "training frames from motion to descriptor and pose",
        ["frames", "seconds", "frames per second", "peak MiB of the process that collects"],
        [[f"{made:,}", f"{took:.0f}", f"{made / took:,.0f}", f"{peak:,.0f}"]],
    )

"""How fast training data are made, and in how much memory: python benchmarks/factory.py [FRAMES].

Motion of walkers, another body and another camera for every sequence, all cores.
"""

import resource
import sys
from time import perf_counter

from timing import report

from silpose.app.config import build_components, load
from silpose.model.training import described

if __name__ == "__main__":
    frames = int(sys.argv[1]) if len(sys.argv) > 1 else 100_000
    rooms = build_components(load(["silhouette/scenes=wide", f"silhouette.scenes.frames={frames}"]))
    started = perf_counter()
    data = rooms.dataset()
    ready = described(rooms, data)
    took = perf_counter() - started
    made = sum(len(z) for z, _ in ready.train)
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024  # KiB on Linux
    report(
        "training frames from motion to descriptor and pose",
        ["frames", "seconds", "frames a second", "peak MiB of the process that collects"],
        [[f"{made:,}", f"{took:.0f}", f"{made / took:,.0f}", f"{peak:,.0f}"]],
    )

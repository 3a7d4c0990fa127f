"""Trees of masks to tables: python benchmarks/masks_tree.py [--fast].

Makes a tree of gait-recognition masks, 128 x 88 pixels, in a temporary folder; measures masks per
second from disk to tables on two cores, and the memory that takes; kills a run, resumes it, and
checks that nothing is lost or done twice.
"""

import contextlib
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import cv2
import numpy as np
from joblib import parallel_config
from timing import FAST, report

from silpose.dataset import Renderer, SamePerformer, render_take
from silpose.descriptor import ShapeContextHistogram
from silpose.model import describe_dataset, load, predict_tree
from silpose.model.trees import read_table
from silpose.motion import WalkerTakes
from silpose.regression import RelevanceVectorRegressor
from silpose.silhouette import Body, Camera

TAKES, FRAMES = (30, 20) if FAST else (1000, 100)
VIEWS = range(0, 181, 18)


def make_tree(root: Path) -> None:
    """Write ``subject/sequence/view/*.png`` of a walker, each take from another frame on."""
    motion = WalkerTakes(test_seconds=28).takes()[-1]
    large = render_take(motion, Body(), Camera(width=192, height=192)).masks
    encoded = []
    for mask in large:
        small = cv2.resize(255 * mask, (128, 128), interpolation=cv2.INTER_AREA)[:, 20:108]
        encoded.append(cv2.imencode(".png", 255 * (small > 127).astype(np.uint8))[1].tobytes())
    for take in range(TAKES):
        sequence, view = divmod(take, len(VIEWS))
        subject = f"{sequence // 10 + 1:03d}"
        name = f"{subject}/nm-{sequence % 10 + 1:02d}/{VIEWS[view]:03d}"
        folder = root / name
        folder.mkdir(parents=True)
        for frame in range(FRAMES):
            content = encoded[(7 * take + frame) % len(encoded)]
            (folder / f"{name.replace('/', '-')}-{frame + 1:03d}.png").write_bytes(content)


def train(file: Path) -> None:
    """Train and save a model of single images, with its confidence."""
    renderer = Renderer(WalkerTakes(seconds=4, test_seconds=4), camera=Camera())
    described = describe_dataset(SamePerformer().load(renderer), ShapeContextHistogram())
    regressor = RelevanceVectorRegressor().fit(*described.joined("train"))
    described.model(regressor).save(file)


def memory(process: int) -> float:
    """Resident memory of a process and all below it, gigabytes."""
    below = Path(f"/proc/{process}/task/{process}/children").read_text().split()
    pages = int(Path(f"/proc/{process}/statm").read_text().split()[1])
    shared = int(Path(f"/proc/{process}/statm").read_text().split()[2])
    return (pages - shared) * 4096 / 1e9 + sum(memory(int(child)) for child in below)


def start(model: Path, root: Path, into: Path) -> subprocess.Popen:
    """Start a run in a process of its own."""
    return subprocess.Popen([sys.executable, __file__, "--run", model, root, into])


def run(model: str, root: str, into: str) -> None:
    """Do a tree, as the process that may be killed."""
    with parallel_config(n_jobs=2):
        print(predict_tree(load(model), root, into).summary())


def watch(process: subprocess.Popen) -> tuple[float, float]:
    """Wait for a process; return its seconds and the most memory, gigabytes."""
    began, most = time.perf_counter(), 0.0
    while process.poll() is None:
        with contextlib.suppress(OSError):  # it ended just now
            most = max(most, memory(process.pid))
        time.sleep(0.1)
    return time.perf_counter() - began, most


def stamps(into: Path) -> dict[Path, int]:
    """When each finished table was written."""
    return {
        file: file.stat().st_mtime_ns for file in into.rglob("[!.]*.csv") if file.parent != into
    }


def main() -> None:
    with tempfile.TemporaryDirectory() as temporary:
        root, model = Path(temporary) / "tree", Path(temporary) / "model.npz"
        make_tree(root)
        train(model)
        seconds, most = watch(start(model, root, Path(temporary) / "whole"))
        killed = Path(temporary) / "killed"
        process = start(model, root, killed)
        while len(stamps(killed)) < TAKES / 3:
            time.sleep(0.05)
        process.send_signal(signal.SIGKILL)
        process.wait()
        time.sleep(2)  # its workers notice, and end
        before = stamps(killed)
        resumed, _ = watch(start(model, root, killed))
        after = stamps(killed)
        twice = sum(after[file] != stamp for file, stamp in before.items())
        whole = stamps(Path(temporary) / "whole")
        lost = len(whole) - len(after)
        wrong = sum(
            not np.array_equal(
                read_table(file)["heading_deg"],
                read_table(killed / file.relative_to(Path(temporary) / "whole"))["heading_deg"],
            )
            for file in list(whole)[:: max(1, len(whole) // 20)]
        )
    masks = TAKES * FRAMES
    rows = [
        ["masks a second, disk to tables, two cores", f"{masks / seconds:.0f}"],
        ["most memory, all processes, GB", f"{most:.2f}"],
        ["takes finished when killed", f"{len(before)}"],
        ["seconds to finish the rest", f"{resumed:.1f}"],
        ["takes lost, done twice, different", f"{lost}, {twice}, {wrong}"],
    ]
    report(f"Tree of {TAKES} takes of {FRAMES} masks of 128 x 88", ["", ""], rows)


if __name__ == "__main__":
    if "--run" in sys.argv:
        run(*sys.argv[2:])
    else:
        main()

"""Components of a few seconds of motion, and a function that runs an experiment on them."""

from dataclasses import dataclass, replace
from pathlib import Path

import cv2
import pytest
from rerun.chunk import RrdReader
from small_components import components_of

from silpose.core.stages import timing
from silpose.dataset import AgarwalFile, CrossPerformer, SamePerformer
from silpose.experiments import EXPERIMENTS
from silpose.motion import MotionFolder, WalkerTakes, save_bvh
from silpose.recording import Result, RunFolder, write_result


@pytest.fixture(scope="session")
def walkers():
    """Walkers of a few seconds."""
    return components_of(SamePerformer(), WalkerTakes(seconds=3, test_seconds=3))


@pytest.fixture(scope="session")
def longer_walkers():
    """Walkers whose test take is long enough for failures."""
    return components_of(SamePerformer(), WalkerTakes(seconds=3, test_seconds=7))


@pytest.fixture(scope="session")
def performers(tmp_path_factory):
    """A folder of BVH files by three performers, 00 to 02, of whom the last is for testing."""
    folder = tmp_path_factory.mktemp("performers")
    for k, take in enumerate(WalkerTakes(seconds=3, test_seconds=3).takes()[:6]):
        save_bvh(folder / f"0{k % 3}_{k}.bvh", take)
    return components_of(CrossPerformer(test=["02"]), MotionFolder(folder))


@pytest.fixture(scope="session")
def authors(shared_mocap):
    """The authors' own data."""
    file = shared_mocap.parent / "paper" / "ankurDataPoseSilhouette.mat"
    return components_of(AgarwalFile(file), WalkerTakes())


@dataclass
class Run:
    """What an experiment returned, and the folder into which it was written."""

    result: Result
    folder: Path
    seconds: dict

    def __post_init__(self):
        self.metrics, self.rows = self.result.metrics, self.result.rows

    def values(self, name):
        """One metric by method."""
        return {m: own[name] for m, own in self.metrics.items() if name in own}


@pytest.fixture(scope="session")
def run(tmp_path_factory):
    """A function that runs an experiment, and writes and checks its files."""

    def call(name, components, *, record=True, **own):
        root = tmp_path_factory.mktemp("recordings")
        folder = RunFolder.start(name, root=str(root), sinks=["file"] if record else [])
        with timing() as seconds:
            told = components if components.run else replace(components, run=folder)
            result = EXPERIMENTS[name](told, **own)
            write_result(folder, result, components.seed, seconds)
        if result.figure is not None:
            assert cv2.imread(str(folder.folder / f"{name}.png")).std() > 10
        if record:
            assert len(list(RrdReader(folder.folder / "run.rrd").stream())) > 5
        return Run(result, folder.folder, seconds)

    return call

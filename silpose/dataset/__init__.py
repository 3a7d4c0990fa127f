"""What is learnt from and tested on: sequences and their split."""

from silpose.dataset.agarwal import AgarwalFile
from silpose.dataset.cross_camera import CrossCamera
from silpose.dataset.cross_performer import CrossPerformer
from silpose.dataset.lazy_masks import LazyMasks
from silpose.dataset.renderer import Renderer
from silpose.dataset.same_performer import SamePerformer, Split
from silpose.dataset.scenes import Scene, SceneSampler
from silpose.dataset.synthesis import photograph, synthesise
from silpose.dataset.take import Dataset, Take, poses

__all__ = [
    "AgarwalFile",
    "CrossCamera",
    "CrossPerformer",
    "Dataset",
    "LazyMasks",
    "Renderer",
    "SamePerformer",
    "Scene",
    "SceneSampler",
    "Split",
    "Take",
    "photograph",
    "poses",
    "synthesise",
]

"""Datasets: takes with true poses and masks, split into training, validation and test.

Motion (`silpose.motion`) is rendered (`silpose.silhouette`), or the authors' file is read;
`silpose.model` describes the takes and learns from them.
"""

from silpose.dataset.agarwal import AgarwalFile
from silpose.dataset.cross_camera import CrossCamera
from silpose.dataset.cross_performer import CrossPerformer
from silpose.dataset.lazy_masks import LazyMasks
from silpose.dataset.same_performer import SamePerformer
from silpose.dataset.scenes import Scene, SceneSampler
from silpose.dataset.splitter import Split, Splitter
from silpose.dataset.synthesis import Renderer, render_take
from silpose.dataset.take import Dataset, DatasetSource, Take, poses

__all__ = [
    "AgarwalFile",
    "CrossCamera",
    "CrossPerformer",
    "Dataset",
    "DatasetSource",
    "LazyMasks",
    "Renderer",
    "SamePerformer",
    "Scene",
    "SceneSampler",
    "Split",
    "Splitter",
    "Take",
    "poses",
    "render_take",
]

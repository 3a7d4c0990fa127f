"""What is learnt from and tested on: sequences and their split."""

from silpose.dataset.agarwal import AgarwalFile
from silpose.dataset.cross_camera import CrossCamera
from silpose.dataset.cross_performer import CrossPerformer
from silpose.dataset.folds import folds
from silpose.dataset.photographs import Photographs
from silpose.dataset.same_performer import SamePerformer, Split
from silpose.dataset.scenes import Scenes, Shot
from silpose.dataset.sequence import Dataset, Sequence, poses
from silpose.dataset.studio import Studio
from silpose.dataset.synthesis import photograph, synthesise

__all__ = [
    "AgarwalFile",
    "CrossCamera",
    "CrossPerformer",
    "Dataset",
    "Photographs",
    "SamePerformer",
    "Scenes",
    "Sequence",
    "Shot",
    "Split",
    "Studio",
    "folds",
    "photograph",
    "poses",
    "synthesise",
]

"""What is learnt from and tested on: sequences and their split."""

from silpose.dataset.agarwal import AgarwalFile
from silpose.dataset.degraded import degraded
from silpose.dataset.same_performer import SamePerformer, Split
from silpose.dataset.sequence import Dataset, Sequence, poses
from silpose.dataset.synthesis import photograph, synthesise

__all__ = [
    "AgarwalFile",
    "Dataset",
    "SamePerformer",
    "Sequence",
    "Split",
    "degraded",
    "photograph",
    "poses",
    "synthesise",
]

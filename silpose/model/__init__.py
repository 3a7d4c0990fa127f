"""From masks to poses: describing a dataset, training on it, and `PoseModel`, which is saved.

Takes a `Dataset`, fits descriptor, regressors, trackers and a body fitter to it, and hands the
fitted parts to experiments, to recordings, and as one file to whoever loads it.
"""

from silpose.model.describe import Descriptor, describe_takes, fit_descriptor
from silpose.model.descriptor_cache import DescriptorCache
from silpose.model.fitter_training import FitterTraining
from silpose.model.loading import load
from silpose.model.pose_fitter import PoseFitter
from silpose.model.pose_model import PoseModel
from silpose.model.poses import Poses, PredictionDetails
from silpose.model.tracker_training import TrackerTraining
from silpose.model.training import DescribedDataset, compare, describe_dataset

__all__ = [
    "DescribedDataset",
    "Descriptor",
    "DescriptorCache",
    "FitterTraining",
    "PoseFitter",
    "PoseModel",
    "Poses",
    "PredictionDetails",
    "TrackerTraining",
    "compare",
    "describe_dataset",
    "describe_takes",
    "fit_descriptor",
    "load",
]

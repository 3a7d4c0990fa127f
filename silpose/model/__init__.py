"""From masks to poses: describing a dataset, training on it, and `PoseModel`, which is saved.

Takes a `Dataset`, fits descriptor, regressors, trackers and a body fitter to it, and hands the
fitted parts to experiments, to recordings, and as one file to whoever loads it.
"""

from silpose.model.answers import check_rate
from silpose.model.describe import Descriptor, describe_takes, fit_descriptor
from silpose.model.described_masks import see_masks
from silpose.model.fitter_training import FitterTraining
from silpose.model.image_overlay import joints_in_image
from silpose.model.loading import load
from silpose.model.model_cache import ModelCache
from silpose.model.pose_fitter import PoseFitter
from silpose.model.pose_model import PoseModel
from silpose.model.pose_stream import PoseStream
from silpose.model.pose_table import pose_columns, pose_csv
from silpose.model.poses import Poses
from silpose.model.prediction_details import PredictionDetails
from silpose.model.tracker_training import TrackerTraining
from silpose.model.training import DescribedDataset, compare, describe_dataset
from silpose.model.trees import predict_tree

__all__ = [
    "DescribedDataset",
    "Descriptor",
    "FitterTraining",
    "ModelCache",
    "PoseFitter",
    "PoseModel",
    "PoseStream",
    "Poses",
    "PredictionDetails",
    "TrackerTraining",
    "check_rate",
    "compare",
    "describe_dataset",
    "describe_takes",
    "fit_descriptor",
    "joints_in_image",
    "load",
    "pose_columns",
    "pose_csv",
    "predict_tree",
    "see_masks",
]

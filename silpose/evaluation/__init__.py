"""How good estimated poses are: metrics, baselines, recovery after failures; and their gait.

Takes true and estimated poses and gives numbers and rows for ``metrics.json`` and
``results.csv``. What loads much is imported on first use: tools need headlines alone.
"""

from typing import TYPE_CHECKING

from silpose.core.lazy_exports import lazy_exports
from silpose.evaluation.baselines import BASELINES, baselines, oracle
from silpose.evaluation.coverage import angles_covered, coverage_by_limb, joints_covered
from silpose.evaluation.error_breakdown import TWIST_ANGLES, error_rows, twist_errors
from silpose.evaluation.explanations import explanations
from silpose.evaluation.heading import (
    HEADING_LIMIT_DEG,
    heading_confidence,
    heading_errors,
    key_angles,
)
from silpose.evaluation.headlines import HEADLINES, best_first, headlines, in_parts
from silpose.evaluation.metrics import METRICS, joint_distances, measure
from silpose.evaluation.pose_differences import KINDS, depth_mirrored, differences, kinds_of
from silpose.evaluation.right_poses import HEADING_DEG, JOINTS_MM, right_poses
from silpose.evaluation.thigh_swing import thigh_swing

if TYPE_CHECKING:
    from silpose.evaluation.density_baselines import (
        DensityBaseline,
        GaussianMixtureRegression,
        SingleGaussian,
        choose_density_baseline,
        neighbour_modes,
    )
    from silpose.evaluation.gait import GaitReport, Walk, gait_report
    from silpose.evaluation.recovery import (
        FailureSequence,
        FailureTrial,
        blank_trials,
        cut_trials,
    )

__getattr__ = lazy_exports(
    __name__,
    {
        "density_baselines": (
            "DensityBaseline",
            "GaussianMixtureRegression",
            "SingleGaussian",
            "choose_density_baseline",
            "neighbour_modes",
        ),
        "gait": ("GaitReport", "Walk", "gait_report"),
        "recovery": ("FailureSequence", "FailureTrial", "blank_trials", "cut_trials"),
    },
)

__all__ = [
    "BASELINES",
    "HEADING_DEG",
    "HEADING_LIMIT_DEG",
    "HEADLINES",
    "JOINTS_MM",
    "KINDS",
    "METRICS",
    "TWIST_ANGLES",
    "DensityBaseline",
    "FailureSequence",
    "FailureTrial",
    "GaitReport",
    "GaussianMixtureRegression",
    "SingleGaussian",
    "Walk",
    "angles_covered",
    "baselines",
    "best_first",
    "blank_trials",
    "choose_density_baseline",
    "coverage_by_limb",
    "cut_trials",
    "depth_mirrored",
    "differences",
    "error_rows",
    "explanations",
    "gait_report",
    "heading_confidence",
    "heading_errors",
    "headlines",
    "in_parts",
    "joint_distances",
    "joints_covered",
    "key_angles",
    "kinds_of",
    "measure",
    "neighbour_modes",
    "oracle",
    "right_poses",
    "thigh_swing",
    "twist_errors",
]

"""Gait analysis: heel strikes, strides, parameters and joint angles from poses over time.

`Walk` checks the poses, `gait_report` analyses them. On the way, `stretch` cuts them at gaps and
takes out jitter, `events` finds heel strikes and toe-offs, `strides` puts them together, and
`parameters` and `curves` average over strides.
"""

from silpose.evaluation.gait.curves import MOVES, PERCENT, AngleCurve
from silpose.evaluation.gait.events import GaitEvent
from silpose.evaluation.gait.facing import azimuth_of_camera
from silpose.evaluation.gait.frame_angles import frame_angles, gait_phase
from silpose.evaluation.gait.parameters import PARAMETERS, GaitParameter, gait_parameters
from silpose.evaluation.gait.report import GaitReport, gait_report
from silpose.evaluation.gait.strides import Stride
from silpose.evaluation.gait.walk import Walk

__all__ = [
    "MOVES",
    "PARAMETERS",
    "PERCENT",
    "AngleCurve",
    "GaitEvent",
    "GaitParameter",
    "GaitReport",
    "Stride",
    "Walk",
    "azimuth_of_camera",
    "frame_angles",
    "gait_parameters",
    "gait_phase",
    "gait_report",
]

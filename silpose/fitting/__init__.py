"""Fit the body to the contour of a mask, started and held by an estimated pose."""

from silpose.fitting.body_fitter import BodyFitter, Knowledge
from silpose.fitting.confidence import DOUBTFUL, Confidence
from silpose.fitting.contour import contour_of
from silpose.fitting.evidence import EVIDENCE
from silpose.fitting.fit import Fit
from silpose.fitting.fitted_body import (
    fitted_joints,
    fitted_silhouettes,
    overlap_classes,
    standing_body_height,
)
from silpose.fitting.geometry import SHAPES
from silpose.fitting.leg_motion import LegMotion
from silpose.fitting.matching import Matching
from silpose.fitting.options import ChosenOptions, FittingOptions
from silpose.fitting.overlap import overlap
from silpose.fitting.prior import PosePrior
from silpose.fitting.stream import TOLERATED, FitterStream
from silpose.fitting.trace import Trace, trace_frame

__all__ = [
    "DOUBTFUL",
    "EVIDENCE",
    "SHAPES",
    "TOLERATED",
    "BodyFitter",
    "ChosenOptions",
    "Confidence",
    "Fit",
    "FitterStream",
    "FittingOptions",
    "Knowledge",
    "LegMotion",
    "Matching",
    "PosePrior",
    "Trace",
    "contour_of",
    "fitted_joints",
    "fitted_silhouettes",
    "overlap",
    "overlap_classes",
    "standing_body_height",
    "trace_frame",
]

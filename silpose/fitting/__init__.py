"""Fit the body to the contour of a mask, started and held by an estimated pose."""

from silpose.fitting.body_fitter import BodyFitter
from silpose.fitting.fit import Fit
from silpose.fitting.likelihood import Matching
from silpose.fitting.prior import PosePrior

__all__ = ["BodyFitter", "Fit", "Matching", "PosePrior"]

"""Descriptors: from a mask to a vector z, the histogram of shape contexts or simpler ones.

Masks of any origin (`silpose.silhouette`) go in; `silpose.regression` and `silpose.tracking` work
on the descriptors.
"""

from silpose.descriptor.alternatives import AlignedMask, HuMoments
from silpose.descriptor.context_space import ContextSpace
from silpose.descriptor.description import Description
from silpose.descriptor.histogram import ShapeContextHistogram

__all__ = [
    "AlignedMask",
    "ContextSpace",
    "Description",
    "HuMoments",
    "ShapeContextHistogram",
]

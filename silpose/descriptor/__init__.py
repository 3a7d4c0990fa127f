"""From a mask to its descriptor z: the histogram of shape contexts, and what else people use."""

from silpose.descriptor.alternatives import AlignedMask, HuMoments
from silpose.descriptor.histogram import Description, ShapeContextHistogram

__all__ = ["AlignedMask", "Description", "HuMoments", "ShapeContextHistogram"]

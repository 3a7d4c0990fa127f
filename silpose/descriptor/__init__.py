"""From a mask to its descriptor z: the histogram of shape contexts."""

from silpose.descriptor.histogram import Description, ShapeContextHistogram

__all__ = ["Description", "ShapeContextHistogram"]

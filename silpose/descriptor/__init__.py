"""From a mask to its descriptor z: the histogram of shape contexts."""

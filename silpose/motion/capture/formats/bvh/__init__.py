"""BVH files: the hierarchy, the frames, and what the channels do."""

from silpose.motion.capture.formats.bvh.reader import read_bvh

__all__ = ["read_bvh"]

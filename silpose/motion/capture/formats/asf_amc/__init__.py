"""ASF and AMC files: a skeleton, and motions of it."""

from silpose.motion.capture.formats.asf_amc.reader import read_asf_amc

__all__ = ["read_asf_amc"]

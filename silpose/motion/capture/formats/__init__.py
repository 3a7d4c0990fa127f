"""Formats of motion capture files, each read into a `RawMotion`.

`read_raw` tells them by the file's ending: BVH, AMC with its ASF, AMASS.
"""

from silpose.motion.capture.formats.amass import holds_motion
from silpose.motion.capture.formats.read_raw import FORMATS, read_raw

__all__ = ["FORMATS", "holds_motion", "read_raw"]

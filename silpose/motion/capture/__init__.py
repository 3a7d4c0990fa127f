"""Motion capture: files of many skeletons, read, checked and put on the project's skeleton.

`MotionFolder` reads a folder of files into `silpose.motion.Motion`. `formats` reads each format
into a `RawMotion`, `naming` finds its joints, `rest` its rest pose; `take` puts all of it together
and tells in a `CaptureReport` what was understood.
"""

from silpose.motion.capture.motion_folder import MotionFolder
from silpose.motion.capture.report import CaptureReport
from silpose.motion.capture.take import CapturedTake

__all__ = ["CaptureReport", "CapturedTake", "MotionFolder"]

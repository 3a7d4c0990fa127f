"""Motion capture: files of many skeletons, read, checked and put on the project's skeleton.

`MotionFolder` reads a folder of BVH or AMASS files into `silpose.motion.Motion`. Names of joints
are recognised by the table ``joint_names.yaml``.
"""

from silpose.motion.capture.motion_folder import MotionFolder

__all__ = ["MotionFolder"]

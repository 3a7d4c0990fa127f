"""Recognition of a file's joints: by their names, their places in the tree, and its shape."""

from silpose.motion.capture.naming.given import Names, check_given
from silpose.motion.capture.naming.match import Matched, match

__all__ = ["Matched", "Names", "check_given", "match"]

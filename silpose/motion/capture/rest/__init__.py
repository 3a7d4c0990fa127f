"""The rest pose of a source: rotations of its joints where the skeleton is in its zero pose.

With G_j(t) the source joint's rotation in the world, our joint's orientation is T_j(t) = G_j(t) C_j
with a constant C_j, which this package finds: from a rest pose in the file (`postures`), or, for
torso and limbs apart, from the skeleton's build and its motion (`torso`, `limbs`).
"""

from silpose.motion.capture.rest.find_rest import Rest, find_rest, rest_axis

__all__ = ["Rest", "find_rest", "rest_axis"]

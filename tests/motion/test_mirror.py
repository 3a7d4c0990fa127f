import numpy as np

from silpose.core import skeleton
from silpose.core.pose_space import wrap_degrees
from silpose.core.skeleton import LIMBS
from silpose.motion import Motion, mirrored


def bones(motion):
    points, _ = skeleton.forward_kinematics(skeleton.rotations_from_angles(motion.angles))
    at = {name: points[:, p] for p, name in enumerate(skeleton.POINTS)}
    directions = {start: at[end] - at[start] for start, end in LIMBS.items()}
    return {k: v / np.linalg.norm(v, axis=1, keepdims=True) for k, v in directions.items()}


def test_limbs_point_the_mirrored_way_and_twice_is_once():
    rng = np.random.default_rng(0)
    angles = rng.uniform(-40, 40, (5, 54))
    motion = Motion("m", "p", 15.0, angles, rng.normal(size=(5, 3)))
    mirror = mirrored(motion)
    np.testing.assert_allclose(mirror.root_position, motion.root_position * [-1, 1, 1])
    np.testing.assert_allclose(wrap_degrees(mirror.angles[:, 0]), -motion.angles[:, 0])
    before, after = bones(motion), bones(mirror)
    for joint in LIMBS:
        side, _, rest = joint.partition("_")
        other = f"{'right' if side == 'left' else 'left'}_{rest}"
        np.testing.assert_allclose(after[joint], before[other] * [-1, 1, 1], atol=1e-9)
    np.testing.assert_allclose(mirrored(mirror).angles, motion.angles, atol=1e-6)

"""From motion to sequences: every pose before the camera."""

from __future__ import annotations

import numpy as np

from silpose.dataset.sequence import Sequence
from silpose.motion import Motion
from silpose.pose import ANGLES
from silpose.silhouette import Body, Camera, render



def photograph(motion: Motion, body: Body, camera: Camera) -> Sequence:
    """Pose the body through a motion and take its masks.

    Parameters
    ----------
    motion : Motion
    body : Body
    camera : Camera

    Returns
    -------
    sequence : Sequence
        Its poses' headings are relative to the camera.
    """
    offset, heading = camera.place(motion.root_position, motion.angles[:, 0])
    angles = np.column_stack([heading, motion.angles[:, 1:]])
    x = ANGLES.from_angles(angles)
    masks = np.stack(list(render(body, camera, ANGLES.rotations(x), offset)))
    return Sequence(motion.name, motion.performer, motion.frames_per_second, x, masks)

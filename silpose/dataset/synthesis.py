"""From motion to sequences: every pose before the camera."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Sequence as Ordered

import numpy as np

from silpose.dataset.same_performer import SamePerformer
from silpose.dataset.sequence import Dataset, Sequence
from silpose.errors import InputError
from silpose.motion import Motion
from silpose.pose import ANGLES
from silpose.progress import bar
from silpose.silhouette import Body, Camera, render


def photograph(
    motion: Motion,
    body: Body,
    camera: Camera,
    advance: Callable[[int], None] = lambda frames: None,
) -> Sequence:
    """Pose the body through a motion and take its masks.

    Parameters
    ----------
    motion : Motion
    body : Body
    camera : Camera
    advance : callable, optional
        Called with 1 after every frame.

    Returns
    -------
    sequence : Sequence
        Its poses' headings are relative to the camera.
    """
    offset, heading = camera.place(motion.root_position, motion.angles[:, 0])
    x = ANGLES.from_angles(np.column_stack([heading, motion.angles[:, 1:]]))
    masks = np.empty((len(motion), camera.height, camera.width), np.uint8)
    for frame, mask in enumerate(render(body, camera, ANGLES.rotations(x), offset)):
        if not mask.any():
            raise InputError(
                f"frame {frame} of take '{motion.name}' is out of the camera's sight: "
                "set silhouette.camera.follow=true or a larger silhouette.camera.distance"
            )
        masks[frame] = mask
        advance(1)
    return Sequence(motion.name, motion.performer, motion.frames_per_second, x, masks, offset)


def synthesise(
    takes: Ordered[Motion], splitter: SamePerformer, body: Body, camera: Camera, name: str
) -> Dataset:
    """Photograph every take that the split uses.

    Parameters
    ----------
    takes : sequence of Motion
    splitter : SamePerformer
    body : Body
    camera : Camera
    name : str
        Of the dataset, as results call it.

    Returns
    -------
    dataset : Dataset
    """
    split = splitter.split([take.name for take in takes])
    by_name = {take.name: take for take in takes}
    used = [*split.train, *split.validation, *split.test]
    with bar("masks", sum(len(by_name[take]) for take in used)) as advance:
        train, validation, test = (
            [photograph(by_name[take], body, camera, advance) for take in part]
            for part in (split.train, split.validation, split.test)
        )
    return Dataset(name, ANGLES, train, validation, test)

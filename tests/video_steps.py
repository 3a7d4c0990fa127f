"""Steps of a film whose poses are made up."""

import numpy as np

from silpose.core.pose_space import ANGLES
from silpose.model import Poses
from silpose.model.video import VideoStep
from silpose.silhouette.person import PersonSelector


def video_steps(sequence, frames, lost=(), live=False):
    """Steps of a rendered take, some of them without a person."""
    selector = PersonSelector(None)
    steps = []
    for k in range(frames):
        seen = k not in lost
        mask = sequence.masks[k] * seen
        _, facts = selector.step(mask)
        x = sequence.x[k : k + 1] * (1.0 if seen else np.nan)
        state = "tracking" if seen else "lost"
        time, iou = np.array([k / 15]), np.array([0.9 if seen else np.nan])
        poses = Poses(x, ANGLES, np.array([0.8 * seen]), [state], time, iou=iou, facts=facts)
        flat = 40 * ANGLES.joints(np.nan_to_num(x))[0, :, :2] * (1, -1) + 48
        corners = np.array([[20.0, 10], [60, 10], [60, 90]])
        place = np.array([0.1 * k, 0.9, -5.0])
        steps.append(
            VideoStep(
                *(k, k / 15, np.full((*mask.shape, 3), 60, np.uint8), mask),
                *("person" if seen else "blank", poses),
                flat if seen else np.full_like(flat, np.nan),
                corners if seen else np.empty((0, 2)),
                place if seen else np.full(3, np.nan),
                latency=0.04 if live else None,
            )
        )
    return steps

"""A small BVH file whose T-pose is the pose of all-zero rotations."""

from pathlib import Path

import numpy as np
import pytest

from silpose.core.skeleton import OFFSETS, PARENTS

UNIT = 0.02  # metres per unit of the file

_T_POSE = {
    "root": (0.0, 0.0, 0.0), "chest": (0.0, 0.29, 0.0), "neck": (0.0, 0.17, 0.0),
    "head": (0.0, 0.16, 0.0),
    "left_collar": (0.05, 0.08, 0.0), "left_shoulder": (0.12, 0.0, 0.0),
    "left_elbow": (0.26, 0.0, 0.0), "left_wrist": (0.25, 0.0, 0.0), "left_hand": (0.16, 0.0, 0.0),
    "right_collar": (-0.05, 0.08, 0.0), "right_shoulder": (-0.12, 0.0, 0.0),
    "right_elbow": (-0.26, 0.0, 0.0), "right_wrist": (-0.25, 0.0, 0.0),
    "right_hand": (-0.16, 0.0, 0.0),
    "left_hip": (0.06, -0.1, 0.0), "right_hip": (-0.06, -0.1, 0.0),
    **{j: OFFSETS[j] for j in ("left_knee", "left_ankle", "right_knee", "right_ankle")},
}  # fmt: skip


NAMES = {
    "root": "Hips", "chest": "Spine1", "neck": "HEadDummy", "head": "Head",
    **{f"{side}_{ours}": f"{side.title()}{name}" for side in ("left", "right") for ours, name in (
        ("collar", "Shoulder"), ("shoulder", "Arm"), ("elbow", "ForeArm"), ("wrist", "Hand"),
        ("hip", "UpLeg"), ("knee", "Leg"), ("ankle", "Foot"),
    )},
}  # fmt: skip


class SmallBvh:
    """Text of a BVH file, to be spoiled by a test.

    `frames` maps a joint of ours to its rotation (z, y, x) in degrees, frame by frame.
    """

    def __init__(
        self, frames=({}, {}, {}), frame_time="0.0333333", without=(), offsets=None, names=None
    ):
        self.frames = frames
        self.frame_time = frame_time
        self.without = without
        self.offsets = _T_POSE | (offsets or {})
        self.names = NAMES | (names or {})
        self.order = []

    def text(self):
        hierarchy = "\n".join(["HIERARCHY", *self._joint("root", 0)])
        rows = [self._row(frame) for frame in self.frames]
        head = f"MOTION\nFrames: {len(rows)}\nFrame Time: {self.frame_time}\n"
        return hierarchy + "\n" + head + "".join(row + "\n" for row in rows)

    def write(self, file: Path):
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(self.text())
        return file

    def _joint(self, joint, depth):
        if depth == 0:
            self.order = []
        self.order.append(joint)
        offset = " ".join(f"{v / UNIT:.6f}" for v in self.offsets[joint])
        yield f"{'JOINT' if depth else 'ROOT'} {self.names[joint]}"
        yield "{"
        yield f"OFFSET {offset}"
        position = "" if depth else " Xposition Yposition Zposition"
        yield f"CHANNELS {3 if depth else 6}{position} Zrotation Yrotation Xrotation"
        children = [j for j in self.offsets if PARENTS.get(j) == joint and j not in self.without]
        for child in children:
            if child.endswith("hand"):
                yield from self._end(self.offsets[child])
            else:
                yield from self._joint(child, depth + 1)
        if not children:
            yield from self._end((0.0, -0.05, 0.1))
        yield "}"

    def _end(self, offset):
        yield "End Site"
        yield "{"
        yield "OFFSET " + " ".join(f"{v / UNIT:.6f}" for v in offset)
        yield "}"

    def _row(self, frame):
        place = frame.get("position", (0.0, 45.0, 0.0))
        rotations = [v for joint in self.order for v in frame.get(joint, (0.0, 0.0, 0.0))]
        return " ".join(str(v) for v in (*place, *rotations))


@pytest.fixture
def small_bvh():
    return SmallBvh


@pytest.fixture
def small_amass():
    """Write a small file in AMASS's layout; `layout` replaces or, by None, leaves out keys."""

    def write(file: Path, rotvec=None, place=None, rate=60.0, columns=156, **layout):
        frames = 9 if rotvec is None else len(rotvec)
        poses = np.zeros((frames, columns))
        if rotvec is not None:
            poses[:, :66] = np.reshape(rotvec, (frames, -1))
        else:
            poses[:, 0] = np.pi / 2  # upright in a world of +Z up
        content = {
            "poses": poses,
            "trans": np.zeros((frames, 3)) if place is None else place,
            "gender": np.array("neutral"),
            "betas": np.zeros(16),
            "mocap_framerate" if columns == 156 else "mocap_frame_rate": np.array(rate),
        } | layout
        file.parent.mkdir(parents=True, exist_ok=True)
        np.savez(file, **{k: v for k, v in content.items() if v is not None})
        return file

    return write

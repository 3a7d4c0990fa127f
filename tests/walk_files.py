"""BVH files of one known walk, on skeletons of any names, axes, units, channels and rest poses."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

# Parent and place in a T-pose, metres, facing +Z; left is mirrored to the right.
_MIDDLE = {
    "root": ("", (0, 0, 0)), "spine": ("root", (0, 0.10, -0.01)),
    "spine1": ("spine", (0, 0.13, 0)), "chest": ("spine1", (0, 0.13, 0)),
    "neck": ("chest", (0, 0.17, -0.01)), "head": ("neck", (0, 0.09, 0.02)),
    "head/end": ("head", (0, 0.18, 0)),
}  # fmt: skip
_SIDE = {
    "collar": ("chest", (0.05, 0.13, 0.01)), "shoulder": ("collar", (0.12, 0.01, 0)),
    "elbow": ("shoulder", (0.28, 0, 0)), "wrist": ("elbow", (0.26, 0, 0)),
    "wrist/end": ("wrist", (0.09, 0, 0)), "hip": ("root", (0.09, -0.05, 0)),
    "knee": ("hip", (0, -0.42, 0)), "ankle": ("knee", (0, -0.42, 0)),
    "toes": ("ankle", (0, -0.07, 0.13)), "toes/end": ("toes", (0, 0, 0.06)),
}  # fmt: skip
TORSO = ("root", "spine", "spine1", "chest", "neck", "head")

MIXAMO = {
    "root": "Hips",
    "spine": "Spine",
    "spine1": "Spine1",
    "chest": "Spine2",
    "neck": "Neck",
    "head": "Head",
    "collar": "Shoulder",
    "shoulder": "Arm",
    "elbow": "ForeArm",
    "wrist": "Hand",
    "hip": "UpLeg",
    "knee": "Leg",
    "ankle": "Foot",
    "toes": "ToeBase",
}
UNREAL = {"root": "pelvis", "spine": "spine_01", "spine1": "spine_02", "chest": "spine_03",
          "neck": "neck_01", "head": "head", "collar": "clavicle_", "shoulder": "upperarm_",
          "elbow": "lowerarm_", "wrist": "hand_", "hip": "thigh_", "knee": "calf_",
          "ankle": "foot_", "toes": "ball_"}  # fmt: skip
NAMES = {
    "mixamo": (MIXAMO, "mixamorig:{left}{part}", "Left", "Right"),
    "plain": (MIXAMO, "{left}{part}", "Left", "Right"),
    "unreal": (UNREAL, "{part}{left}", "l", "r"),
    "strange": ({name: f"K{n}" for n, name in enumerate(MIXAMO)}, "{left}{part}", "a", "b"),
}

UP = {
    "y": np.eye(3),
    "z": np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]]),
    "-y": np.diag([1.0, -1, -1]),
    "x": np.array([[0.0, 1, 0], [-1, 0, 0], [0, 0, 1]]),
}
"""Rotations from a world of +Y up to one in which another axis points up."""


@dataclass(frozen=True)
class WalkFile:
    """A file of a walk, and how it is written.

    Angles are degrees, lengths metres. `rest` is the pose of all-zero rotations: ``t``, ``a``
    (arms 45 degrees down), ``along_x`` (every bone along +X) or ``random`` axes of every joint.
    """

    frames: int = 60
    rate: float = 30.0
    heading: float = 0.0
    turning: float = 20.0
    stoop: float = 0.0
    twist: float = 0.0
    bow: float = 0.0  # of the pelvis
    backwards: bool = False
    rest: str = "t"
    begins: str = ""  # "t" or "n": a first frame in such a pose
    up: str = "y"
    rest_up: str = "y"
    mirrored: bool = False
    unit: float = 0.01
    names: str = "plain"
    inner_positions: bool = False
    toes: bool = True
    seed: int = 0

    def joints(self) -> dict[str, tuple[str, np.ndarray]]:
        """Parent and place in the T-pose, by name; parents first."""
        rng = np.random.default_rng(self.seed)
        size = {name: rng.uniform(0.92, 1.08) for name in (*_MIDDLE, *_SIDE)}
        found = {n: (p, size[n] * np.array(o, dtype=float)) for n, (p, o) in _MIDDLE.items()}
        for side, sign in (("left", 1), ("right", -1)):
            for name, (parent, place) in _SIDE.items():
                if "toes" in name and not self.toes:
                    continue
                above = parent if parent in _MIDDLE else f"{side}_{parent}"
                found[f"{side}_{name}"] = (above, size[name] * np.array(place) * [sign, 1, 1])
        return found

    def walk(self) -> tuple[dict[str, np.ndarray], dict[str, np.ndarray]]:
        """Rotations against the T-pose (F, 3, 3) and positions (F, 3) by joint, +Y up, metres."""
        turns = self._local_turns()
        joints = self.joints()
        rotations, positions = {}, {}
        for name, (parent, place) in joints.items():
            own = turns.get(name, np.tile(np.eye(3), (self.frames, 1, 1)))
            rotations[name] = rotations[parent] @ own if parent else own
            positions[name] = (
                positions[parent] + rotations[parent] @ place
                if parent
                else np.zeros((self.frames, 3))
            )
        # The hips move as the standing foot pushes: the left one while the right leg swings.
        feet = np.stack([positions[f"{side}_ankle"] for side in ("left", "right")])
        standing = (np.cos(self._phase()) > 0).astype(int)
        step = np.diff(feet, axis=1)[standing[1:], np.arange(self.frames - 1)]
        way = -np.concatenate([np.zeros((1, 3)), np.cumsum(step * [1, 0, 1], axis=0)])
        way[:, 1] = 0.08 - feet[standing, np.arange(self.frames), 1]
        if self.begins:
            way[:2] = way[2] * [1, 0, 1] + [0, 0.9, 0]
        return rotations, {name: place + way for name, place in positions.items()}

    def _phase(self) -> np.ndarray:
        way = -1 if self.backwards else 1
        return way * 2 * np.pi * 0.9 * np.arange(self.frames) / self.rate

    def _local_turns(self) -> dict[str, np.ndarray]:
        phase = self._phase()
        moving = np.ones(self.frames)
        if self.begins:
            moving[0] = 0.0
        bow = moving * self.bow
        heading = self.heading + self.turning * np.abs(phase) / 5.65
        turn = {"root": _turn("y", heading) @ _turn("x", bow)}
        for joint in ("spine", "spine1", "chest"):
            twist = _turn("y", moving * (self.twist / 3 - 2 * np.sin(phase)))
            turn[joint] = _turn("x", moving * self.stoop / 3) @ twist
        for side, sign in (("left", 1), ("right", -1)):
            swing = sign * np.sin(phase)
            bend = 5 + 50 * np.clip(sign * np.cos(phase), 0, 1)
            turn[f"{side}_hip"] = _turn("x", moving * -(5 + 24 * swing) - bow)
            turn[f"{side}_knee"] = _turn("x", moving * bend)
            turn[f"{side}_ankle"] = _turn("x", moving * (24 * swing - bend + 5) * 0.6)
            hang = np.where(moving, 75.0, 0.0 if self.begins == "t" else 85.0)
            swung = _turn("x", moving * 20 * swing)
            turn[f"{side}_shoulder"] = swung @ _turn("z", -sign * hang)
            turn[f"{side}_elbow"] = _turn("y", moving * -sign * (30 - 15 * swing))
        return turn

    def axes(self) -> dict[str, np.ndarray]:
        """Rotation of every joint of the file in the T-pose: what makes its rest pose another."""
        rng = np.random.default_rng(self.seed + 1)
        found = {}
        for name in self.joints():
            side = 1 if name.startswith("left") else -1
            if self.rest == "random":
                found[name] = Rotation.random(random_state=rng).as_matrix()
            elif self.rest == "along_x":
                found[name] = _along_x(name, side)
            elif self.rest == "a" and any(j in name for j in ("shoulder", "elbow", "wrist")):
                found[name] = _turn("z", side * 45.0)[0]
            else:
                found[name] = np.eye(3)
        return found

    def text(self) -> str:
        """The file's text."""
        rotations, positions = self.walk()
        reflect = np.diag([-1.0, 1, 1]) if self.mirrored else np.eye(3)
        world, rest_world = UP[self.up], UP[self.rest_up]
        axes, joints = self.axes(), self.joints()
        turned = {n: reflect @ world @ r @ axes[n] @ rest_world.T @ reflect
                  for n, r in rotations.items()}  # fmt: skip
        place = {n: p @ (reflect @ world).T / self.unit for n, p in positions.items()}
        offset = {
            name: reflect @ rest_world @ (axes[parent].T @ o if parent else o) / self.unit
            for name, (parent, o) in joints.items()
        }
        rng = np.random.default_rng(self.seed + 2)
        lines, columns = ["HIERARCHY"], []

        def write(name: str) -> None:
            parent = joints[name][0]
            children = [n for n, (p, _) in joints.items() if p == name]
            what = "End Site" if name.endswith("/end") else f"JOINT {self.name_of(name)}"
            lines.append(what if parent else f"ROOT {self.name_of(name)}")
            lines.extend(["{", "OFFSET " + " ".join(f"{v:.6f}" for v in offset[name])])
            if not name.endswith("/end"):
                order = "".join(rng.permutation(list("XYZ")))
                channels = [f"{axis}rotation" for axis in order]
                local = turned[parent].transpose(0, 2, 1) @ turned[name] if parent else turned[name]
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore")  # gimbal lock, where any split will do
                    columns_here = Rotation.from_matrix(local).as_euler(order, degrees=True)
                if not parent or self.inner_positions:
                    channels = ["Xposition", "Yposition", "Zposition", *channels]
                    here = np.tile(offset[name], (self.frames, 1)) if parent else place[name]
                    columns_here = np.hstack([here, columns_here])
                lines.append(f"CHANNELS {len(channels)} {' '.join(channels)}")
                columns.append(columns_here)
            for child in children:
                write(child)
            lines.append("}")

        write("root")
        rows = np.hstack(columns)
        head = ["MOTION", f"Frames: {self.frames}", f"Frame Time: {1 / self.rate:.6f}"]
        return "\n".join([*lines, *head, *(" ".join(f"{v:.6f}" for v in row) for row in rows), ""])

    def name_of(self, joint: str) -> str:
        """Name of a joint in the file."""
        parts, pattern, left, right = NAMES[self.names]
        side, _, part = joint.rpartition("_")
        return pattern.format(part=parts[part], left={"left": left, "right": right}.get(side, ""))

    def write(self, file: Path) -> Path:
        """Write the file."""
        file.write_text(self.text())
        return file


def _turn(axis: str, degrees: np.ndarray) -> np.ndarray:
    return Rotation.from_euler(axis, np.reshape(degrees, (-1, 1)), degrees=True).as_matrix()


def _along_x(name: str, side: int) -> np.ndarray:
    """Axes of a joint whose bone points along its own +X, as in LAFAN1."""
    if name.split("_")[0] in (*TORSO, "head/end"):
        columns = [(0, 1, 0), (0, 0, 1), (1, 0, 0)]
    elif any(joint in name for joint in ("hip", "knee", "ankle", "toes")):
        columns = [(0, -1, 0), (0, 0, -1), (1, 0, 0)]
    else:
        columns = [(side, 0, 0), (0, 0, 1), (0, -side, 0)]
    return np.array(columns, dtype=float).T

"""A small ASF with its AMC, whose bones turn in axes of their own."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

# Name, parent, direction, length, axes (degrees), degrees of freedom.
BONES = (
    ("lowerback", "root", (0, 1, 0), 2.0, (0, 0, 0), "rx ry rz"),
    ("thorax", "lowerback", (0, 2, 0), 1.5, (10, 20, 30), "rz rx ry"),
    ("lhumerus", "thorax", (1, 0, 0), 3.0, (180, -30, 90), "rx ry rz"),
    ("lradius", "lhumerus", (1, 0, 0), 2.5, (-90, 30, 0), "rx"),
    ("lfemur", "root", (0.34202, -0.939693, 0), 7.6, (0, 0, 20), "rx ry rz"),
    ("skull", "thorax", (0, 1, 0.1), 1.0, (0, 0, 0), ""),
)


class SmallAsf:
    """Texts of an ASF and an AMC, to be spoiled by a test; `degrees` maps bones to values."""

    def __init__(self, frames=3, seed=0):
        rng = np.random.default_rng(seed)
        self.values = {"root": rng.uniform(-90, 90, (frames, 6))} | {
            name: rng.uniform(-90, 90, (frames, len(moves.split())))
            for name, *_, moves in BONES
            if moves
        }

    def asf(self):
        lines = ["# made by a test", ":version 1.10", ":name VICON", ":units", "  mass 1.0",
                 "  length 0.45", "  angle deg", ":documentation", "  none of it", ":root",
                 "  order TX TY TZ RX RY RZ", "  axis XYZ", "  position 0 0 0",
                 "  orientation 0 0 0", ":bonedata"]  # fmt: skip
        for n, (name, _, direction, length, axes, moves) in enumerate(BONES, start=1):
            lines += ["  begin", f"    id {n}", f"    name {name}",
                      f"    direction {' '.join(map(str, direction))}", f"    length {length}",
                      f"    axis {' '.join(map(str, axes))} XYZ"]  # fmt: skip
            if moves:
                lines += [f"    dof {moves}", "    limits (-160.0 20.0)"]
                lines += ["           (-70.0 70.0)"] * (len(moves.split()) - 1)
            lines.append("  end")
        lines += [":hierarchy", "  begin", "    root lowerback lfemur", "    lowerback thorax",
                  "    thorax lhumerus skull", "    lhumerus lradius", "  end"]  # fmt: skip
        return "\n".join(lines) + "\n"

    def amc(self):
        lines = ["#!OML:ASF a comment", ":FULLY-SPECIFIED", ":DEGREES"]
        for f in range(len(self.values["root"])):
            lines.append(str(f + 1))
            lines += [
                f"{n} {' '.join(map(repr, map(float, v[f])))}" for n, v in self.values.items()
            ]
        return "\n".join(lines) + "\n"

    def write(self, folder, asf="02.asf", amc="02_01.amc"):
        for name, text in ((asf, self.asf()), (amc, self.amc())):
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(text)
        return folder / amc

    def world(self, frame):
        """Rotation in the world, start and end of every bone, by the textbook's recursion."""
        place, turn = self.values["root"][frame, :3], self.values["root"][frame, 3:]
        found = {"root": (Rotation.from_euler("xyz", turn, degrees=True), place, place)}
        for name, parent, direction, length, axes, moves in BONES:
            own = Rotation.from_euler("xyz", axes, degrees=True)
            turned = Rotation.identity()
            values = self.values[name][frame] if moves else ()
            for move, value in zip(moves.split(), values, strict=True):
                turned = Rotation.from_euler(move[1], value, degrees=True) * turned
            world = found[parent][0] * own * turned * own.inv()
            start = found[parent][2]
            bone = length * np.array(direction) / np.linalg.norm(direction)
            found[name] = (world, start, start + world.apply(bone))
        return found


@pytest.fixture
def small_asf():
    return SmallAsf

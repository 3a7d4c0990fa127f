"""Small synthetic motion for tests."""

import numpy as np

from silpose.core.skeleton import ANGLES
from silpose.motion import Motion, MotionSource


def swinging(frames: int, seed: int = 0, turns: float = 1.0) -> np.ndarray:
    """Angles (frames, 54) of a person who swings arms and legs while turning on the spot."""
    rng = np.random.default_rng(seed)
    phase = 2 * np.pi * np.arange(frames) / 15 + rng.uniform(0, 2 * np.pi)
    angles = np.zeros((frames, 54))
    angles[:, 0] = 360 * turns * np.arange(frames) / frames
    for side, sign in (("left", 1), ("right", -1)):
        swing = sign * np.sin(phase)
        angles[:, ANGLES.index(f"{side}_hip_x")] = -5 + 25 * swing
        angles[:, ANGLES.index(f"{side}_knee_x")] = 15 + 15 * np.cos(phase * sign)
        angles[:, ANGLES.index(f"{side}_shoulder_z")] = -65 * sign
        angles[:, ANGLES.index(f"{side}_shoulder_y")] = 15 * swing
        angles[:, ANGLES.index(f"{side}_elbow_y")] = -20 * sign
    return angles


def motion(name: str, frames: int, seed: int = 0) -> Motion:
    """A motion of `swinging` on the spot."""
    return Motion(name, "someone", 15.0, swinging(frames, seed), np.zeros((frames, 3)))


class Takes(MotionSource):
    """A source of given motion."""

    name = "synthetic"

    def __init__(self, takes: list[Motion]) -> None:
        self.given = takes

    def read(self) -> list[Motion]:
        """All of it."""
        return self.given

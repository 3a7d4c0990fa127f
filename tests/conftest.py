"""Small synthetic fixtures, and the real motion capture for those who have it."""

import os
from pathlib import Path

import numpy as np
import pytest

from silpose.dataset import photograph
from silpose.motion import Motion
from silpose.silhouette import Body, Camera
from silpose.skeleton import ANGLES

os.environ.setdefault("RERUN_STRICT", "1")  # a wrong call is an error, not a warning

PROJECT = Path(__file__).parents[1]


def swinging(frames: int, seed: int = 0, turns: float = 1.0) -> np.ndarray:
    """Angles (frames, 54) of someone who swings arms and legs while turning on the spot."""
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


@pytest.fixture(scope="session")
def body():
    return Body("convex", level=2)


@pytest.fixture(scope="session")
def camera():
    return Camera(width=96, height=96)


@pytest.fixture(scope="session")
def sequence(body, camera):
    """40 frames of a small person, masks 96 x 96."""
    return photograph(motion("swinging", 40), body, camera)


@pytest.fixture(scope="session")
def shared_mocap():
    """The folder of real motion capture; CI has it, and fails where it is missing."""
    folder = PROJECT.parent / "shared" / "mocap"
    if not folder.is_dir():
        if os.environ.get("CI"):
            pytest.fail("the real motion capture is missing in CI")
        pytest.skip("the real motion capture is not on this machine")
    return folder

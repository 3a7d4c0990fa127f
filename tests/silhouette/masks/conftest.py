"""A small figure, and a folder of it."""

import cv2
import numpy as np
import pytest


def figure(height=48, width=40, shift=0):
    """A mask of 0 and 1: head, trunk, and two legs."""
    mask = np.zeros((height, width), np.uint8)
    centre = width // 2 + shift
    cv2.circle(mask, (centre, 10), 4, 1, -1)
    mask[13:28, centre - 5 : centre + 6] = 1
    mask[28:42, centre - 5 : centre - 1] = mask[28:42, centre + 2 : centre + 6] = 1
    return mask


@pytest.fixture(scope="session")
def figures():
    """Six masks (48, 40)."""
    return [figure(shift=shift) for shift in range(-3, 3)]


@pytest.fixture
def folder_of(tmp_path):
    """Makes a folder of images, by their names."""

    def make(images, name="masks"):
        folder = tmp_path / name
        folder.mkdir(exist_ok=True)
        for file, pixels in images.items():
            cv2.imwrite(str(folder / file), pixels)
        return folder

    return make


@pytest.fixture(scope="session")
def photo():
    """Colours of many shades (48, 40, 3)."""
    noise = np.random.default_rng(0).integers(0, 256, (48, 40, 3), dtype=np.uint8)
    smooth = cv2.GaussianBlur(noise, (0, 0), 2)
    return np.dstack([cv2.equalizeHist(channel) for channel in cv2.split(smooth)])

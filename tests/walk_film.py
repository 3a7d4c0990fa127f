"""A film of a person who walks by, in metres, whose poses, places and masks are known."""

from dataclasses import dataclass

import numpy as np
from synthetic import swinging
from video_films import noisy, paint, wall, write_film

from silpose.core.pose_space import ANGLES
from silpose.descriptor import ShapeContextHistogram
from silpose.fitting import BodyFitter, Confidence, PosePrior
from silpose.model import PoseFitter, PoseModel
from silpose.regression import RidgeRegressor
from silpose.silhouette import Camera, render

RATE = 25.0
CAMERA = Camera(1.2, 5.0, 4.5, width=192, height=144, follow=False)  # 0.9 longer sides
PATH = np.array([[-0.9, 0.92, 0.0], [0.9, 0.92, 0.0]])  # metres in the world


@dataclass
class WalkFilm:
    """The film's file, and what is true of its frames."""

    file: object
    x: np.ndarray
    offset: np.ndarray
    masks: list


def walk_of(body, frames):
    """Poses (F, 55), places (F, 3) and masks of a walk to the right."""
    way = np.linspace(0, 1, frames)[:, None]
    angles = swinging(frames, turns=0)
    offset, angles[:, 0] = CAMERA.place((1 - way) * PATH[0] + way * PATH[1], np.full(frames, 90.0))
    x = ANGLES.from_angles(angles)
    return x, offset, list(render(body, CAMERA, ANGLES.rotations(x), offset))


def film_walk(file, body, frames=18, empty=3):
    """Write the film; the last frames, and the first one, show nobody."""
    x, offset, masks = walk_of(body, frames)
    rng = np.random.default_rng(1)
    blank = np.zeros_like(masks[0])
    every = [blank, *masks, *[blank] * empty]
    pictures = [noisy(paint(wall(), mask), rng) for mask in every]
    return WalkFilm(write_film(file, pictures, rate=int(RATE)), x, offset, every)


def walk_model(body):
    """A small model of the walk, which fits bodies with nothing known of the camera."""
    x, _, masks = walk_of(body, 40)
    histogram = ShapeContextHistogram(codebook_size=30)
    z = histogram.fit_transform(masks)
    prior = PosePrior(25.0 * np.eye(54), 2e4 * np.eye(54))
    expected, sure = Camera(width=96, height=96), Confidence(usual_iou=0.9)
    fitter = BodyFitter(body, expected, prior, camera_is="estimated", iterations=4, confidence=sure)
    regressor = RidgeRegressor(damping=10).fit(z, x)
    return PoseModel(histogram, regressor, ANGLES, 25.0, None, PoseFitter(fitter, z, x, 0))

"""Films of a rendered person before a textured wall, whose masks are known."""

import cv2
import numpy as np


def wall(height=144, width=192, seed=0):
    """A textured, slightly coloured wall."""
    rng = np.random.default_rng(seed)
    coarse = rng.uniform(90, 190, (9, 12, 3)).astype(np.float32)
    return cv2.resize(coarse, (width, height), interpolation=cv2.INTER_CUBIC).clip(40, 220)


def paint(scene, truth, colour=(200, 40, 40)):
    """Paint a person into a scene."""
    picture = scene.copy()
    picture[truth > 0] = colour
    return picture


def noisy(picture, rng, sigma=2.0):
    return (picture + rng.normal(0, sigma, picture.shape)).clip(0, 255).astype(np.uint8)


def figure(masks, frame, height=144, width=192, step=4):
    """A person of a rendered take, walking from left to right."""
    mask = masks[frame % len(masks)]
    rows, columns = np.nonzero(mask)
    person = mask[rows.min() : rows.max() + 1, columns.min() : columns.max() + 1]
    scale = 90 / person.shape[0]
    person = cv2.resize(person, None, fx=scale, fy=scale, interpolation=cv2.INTER_NEAREST)
    whole = np.zeros((height, width), np.uint8)
    left = 8 + step * frame
    part = whole[30 : 30 + person.shape[0], left : left + person.shape[1]]
    part[:] = person[: part.shape[0], : part.shape[1]]
    return whole


def write_film(file, pictures, rate=25, codec="mp4v"):
    """Write RGB pictures."""
    height, width = pictures[0].shape[:2]
    film = cv2.VideoWriter(str(file), cv2.VideoWriter.fourcc(*codec), rate, (width, height))
    for picture in pictures:
        film.write(picture[:, :, ::-1])
    film.release()
    return file


def overlap(one, other):
    return (one & other).sum() / max(1, (one | other).sum())

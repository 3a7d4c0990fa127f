"""Ways in which people store masks, each without loss, and ways of handing them over."""

from collections.abc import Callable
from pathlib import Path

import cv2
import numpy as np
from PIL import Image

Masks = list[np.ndarray]


def _shadowed(mask):
    """Grey 127 beside the person, as background subtraction marks shadows."""
    around = cv2.dilate(mask, np.ones((1, 9), np.uint8)) - mask
    return 255 * mask + 127 * around


def _colours(mask, person, background=(0, 0, 0)):
    return np.where(mask[..., None] > 0, np.uint8(person), np.uint8(background))


def _with_alpha(colours, mask):
    return np.dstack([colours, 255 * mask])


ENCODINGS: dict[str, Callable[[np.ndarray], np.ndarray]] = {
    "bool": lambda mask: mask > 0,
    "0 and 1": lambda mask: mask,
    "0 and 255": lambda mask: 255 * mask,
    "float": lambda mask: mask.astype(np.float32),
    "float to 255": lambda mask: 255.0 * mask,
    "scores": lambda mask: 7.5 * mask - 3.0,
    "integers": lambda mask: mask.astype(np.int64),
    "16 bits, 0 and 1": lambda mask: mask.astype(np.uint16),
    "16 bits, full": lambda mask: 65535 * mask.astype(np.uint16),
    "16 bits, an instance": lambda mask: 2001 * mask.astype(np.uint16),
    "inverted": lambda mask: 255 * (1 - mask),
    "shadow": _shadowed,
    "white in colours": lambda mask: _colours(mask, (255, 255, 255)),
    "red": lambda mask: _colours(mask, (200, 0, 0)),
    "black on white in colours": lambda mask: _colours(mask, (0, 0, 0), (255, 255, 255)),
    "grey and alpha": lambda mask: np.dstack([np.full_like(mask, 255), 255 * mask]),
    "cut out": lambda mask: _with_alpha(_colours(mask, (90, 140, 60)), mask),
    "white, alpha": lambda mask: _with_alpha(np.full((*mask.shape, 3), 255, np.uint8), mask),
}
"""From a mask of 0 and 1 to an array."""

IN_BYTES = [name for name in ENCODINGS if ENCODINGS[name](np.ones((1, 1), np.uint8)).dtype == "u1"]


def array(pictures, folder: Path):
    return np.stack(pictures)


def listed(pictures, folder: Path):
    return list(pictures)


def generated(pictures, folder: Path):
    return (picture for picture in pictures)


def objects(pictures, folder: Path):
    held = np.empty(len(pictures), object)
    held[:] = list(pictures)
    return held


def npy(pictures, folder: Path):
    np.save(folder / "masks.npy", np.stack(pictures))
    return folder / "masks.npy"


def npz(pictures, folder: Path):
    np.savez_compressed(folder / "masks.npz", masks=np.stack(pictures), rate=15)
    return str(folder / "masks.npz")


def images(pictures, folder: Path):
    return [Image.fromarray(picture) for picture in pictures]


def _files(pictures, folder: Path, suffix: str, **options):
    for k, picture in enumerate(pictures):
        Image.fromarray(picture).save(folder / f"mask {k}{suffix}", **options)
    return folder


def png(pictures, folder: Path):
    return _files(pictures, folder, ".png")


def bmp(pictures, folder: Path):
    plain = all(picture.ndim == 2 or picture.shape[2] == 3 for picture in pictures)
    return _files(pictures, folder, ".bmp" if plain else ".png")  # it has no alpha


def webp(pictures, folder: Path):
    return _files(pictures, folder, ".webp", lossless=True, exact=True)


def paths(pictures, folder: Path):
    _files(pictures, folder, ".png")
    return [str(folder / f"mask {k}.png") for k in range(len(pictures))]


def _animated(pictures, file: Path, **options):
    first, *others = (Image.fromarray(picture) for picture in pictures)
    first.save(file, save_all=True, append_images=others, **options)
    return file


def tiff(pictures, folder: Path):
    return _animated(pictures, folder / "masks.tiff", compression="tiff_lzw")


def apng(pictures, folder: Path):
    return _animated(pictures, folder / "masks.png", duration=40)


def animated_webp(pictures, folder: Path):
    return _animated(pictures, folder / "masks.webp", duration=40, lossless=True)


def gif(pictures, folder: Path):
    return _animated(pictures, folder / "masks.gif", duration=40)


def video(pictures, folder: Path):
    height, width = pictures[0].shape[:2]
    file = folder / "masks.avi"
    writer = cv2.VideoWriter(str(file), cv2.VideoWriter.fourcc(*"FFV1"), 25, (width, height))
    for picture in pictures:
        colours = picture if picture.ndim == 3 else np.repeat(picture[..., None], 3, axis=2)
        writer.write(np.ascontiguousarray(colours[:, :, ::-1]))
    writer.release()
    return file


OF_ARRAYS = (array, listed, generated, objects, npy, npz)
"""Ways for arrays of any type."""

OF_BYTES = (images, png, bmp, webp, paths, tiff)
"""Ways for pictures of bytes, with or without colours and alpha."""

OF_FILMS = (apng, animated_webp, gif, video)
"""Ways that have a rate, for pictures of bytes without alpha."""


def run_lengths_of(mask):
    """Lengths of the runs of a mask, column by column."""
    values = np.concatenate([[0], mask.T.ravel(), [2]])
    edges = np.flatnonzero(np.diff(values))
    return np.diff(np.concatenate([[0], edges])).tolist()

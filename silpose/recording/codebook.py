"""The codebook as an image: its centres as the log-polar histograms they are, and their votes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from silpose.core.types import Array
from silpose.recording import entity_paths, palette

if TYPE_CHECKING:
    from silpose.recording.frame_logger import FrameLogger

_TILE = 40  # pixels that a centre is drawn in
_REACH = 17.0  # pixels from a tile's middle to the edge of the outermost ring


def columns_of(count: int) -> int:
    """Count the centres in a row of the image."""
    return int(np.ceil(np.sqrt(count)))


def centre_colours(count: int) -> NDArray[np.uint8]:
    """Colour of each centre, shape (K, 3), wherever centres are told apart."""
    return np.array([palette.hue(k, count) for k in range(count)], np.uint8)


def codebook_picture(codebook: NDArray[np.floating], angular_bins: int) -> NDArray[np.uint8]:
    """Draw all centres, row after row, each in its colour: opaque where the contour lies.

    Parameters
    ----------
    codebook : ndarray, shape (K, radial_bins * angular_bins)
    angular_bins : int

    Returns
    -------
    picture : ndarray of uint8, shape (H, W, 4)
        Red, green, blue and opacity. Rings are equally wide, as in a log-polar plot; right is
        right and down is down.
    """
    y, x = np.mgrid[:_TILE, :_TILE] - (_TILE - 1) / 2
    ring = np.floor(np.hypot(x, y) / _REACH * (codebook.shape[1] // angular_bins)).astype(int)
    turns = np.arctan2(y, x) / (2 * np.pi)
    sector = np.floor(turns * angular_bins + 0.5).astype(int) % angular_bins
    inside = ring < codebook.shape[1] // angular_bins
    places = np.where(inside, ring * angular_bins + sector, 0)
    columns = columns_of(len(codebook))
    rows = int(np.ceil(len(codebook) / columns))
    picture = np.zeros((rows * _TILE, columns * _TILE, 4))
    for k, (centre, colour) in enumerate(zip(codebook, centre_colours(len(codebook)), strict=True)):
        light = (centre / max(float(centre.max()), 1e-9))[places]
        tile = np.dstack([np.broadcast_to(colour, (*light.shape, 3)), 255 * (0.14 + 0.86 * light)])
        top, left = _TILE * np.array(divmod(k, columns))
        picture[top : top + _TILE, left : left + _TILE][inside] = tile[inside]
    return picture.astype(np.uint8)


def log_codebook(
    logger: FrameLogger, codebook: NDArray[np.floating], angular_bins: int, z: Array
) -> None:
    """Log the image, and below every centre a bar as long as its share of each frame's votes.

    A bar across the whole tile is the largest share that occurs.
    """
    logger.image(entity_paths.CODEBOOK, codebook_picture(codebook, angular_bins))
    count = len(codebook)
    rows, columns = np.divmod(np.arange(count), columns_of(count))
    starts = np.stack([columns * _TILE + 1.0, (rows + 1) * _TILE - 2.0], axis=1)
    shares = np.nan_to_num(z) / max(float(np.nanmax(z)), 1e-9)
    strips = np.repeat(starts[None, :, None], len(z), axis=0).repeat(2, axis=2)
    strips[:, :, 1, 0] += shares * (_TILE - 2)
    logger.strips(
        entity_paths.VOTES,
        strips.reshape(-1, 2, 2).astype(np.float32),
        [count] * len(z),
        palette.NEUTRAL,
        2.0,
    )

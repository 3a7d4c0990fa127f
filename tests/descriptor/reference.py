"""The definition of shape contexts written out in NumPy, as slow as it is plain."""

import cv2
import numpy as np
from scipy import ndimage


def boundary(mask, closing=0.0):
    rows, columns = (np.flatnonzero(mask.any(axis=axis)) for axis in (1, 0))
    margin = round(closing * max(np.ptp(rows) + 1, np.ptp(columns) + 1) / 2)
    square = np.ones((2 * margin + 1, 2 * margin + 1))
    padded = np.pad(mask, 2 * margin)
    closed = ndimage.binary_closing(padded, square).astype(np.uint8)
    contours, _ = cv2.findContours(closed, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE)
    return [contour[:, 0] - 2 * margin for contour in contours]


def contexts(pixels, points, reach, inner, angular_bins, radial_bins):
    """Histogram (P, radial * angular) of all pixels around each point, each summing to 1."""
    offset = pixels[None].astype(int) - points[:, None]
    squared = (offset**2).sum(axis=-1)
    bounds = np.geomspace(inner, reach, radial_bins)
    ring = (squared[..., None] > bounds**2).sum(axis=-1)
    turns = np.arctan2(offset[..., 1], offset[..., 0]) / (2 * np.pi)
    sector = np.floor(turns * angular_bins + 0.5).astype(int) % angular_bins
    seen = (ring < radial_bins) & (squared > 0)
    counts = np.zeros((len(points), radial_bins * angular_bins))
    rows = np.broadcast_to(np.arange(len(points))[:, None], seen.shape)
    np.add.at(counts, (rows[seen], (ring * angular_bins + sector)[seen]), 1)
    return counts / np.maximum(counts.sum(axis=1, keepdims=True), 1)


def votes(contexts, codebook, voters, width):
    """Soft votes (K,) of all contexts into their nearest centres."""
    squared = ((contexts[:, None].astype(float) - codebook) ** 2).sum(axis=-1)
    nearest = np.argsort(squared, axis=1, kind="stable")[:, :voters]
    d = np.take_along_axis(squared, nearest, axis=1)
    weights = np.exp((d[:, :1] - d) / (2 * width**2))
    weights /= weights.sum(axis=1, keepdims=True)
    z = np.zeros(len(codebook))
    np.add.at(z, nearest, weights)
    return z / len(contexts)

"""Logging the fitted body: each part a mesh that turns with its joint."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import rerun as rr
from scipy.spatial import ConvexHull

from silpose.core.pose_space import ANGLES
from silpose.core.types import Array, Array32, Indices
from silpose.recording import entity_paths, palette
from silpose.recording.frame_logger import FrameLogger
from silpose.silhouette import Body, RigidLinks

_LEVEL = 1  # detail of the body that is drawn


def log_fitted_body(
    logger: FrameLogger, x: Array, root: Array, shape: Sequence[float] | None = None
) -> None:
    """Log a body in poses; nothing is drawn of a row of NaN.

    Parameters
    ----------
    logger : FrameLogger
    x : ndarray, shape (F, 55)
    root : ndarray, shape (F, 3)
        Position of the root in the world, metres.
    shape : sequence of 10 floats, optional
        Shape coefficients; those of the mean body if not given.
    """
    body = Body("convex", _LEVEL, shape=shape)
    links = RigidLinks.of(body)
    posed = body.pieces(ANGLES.rotations(np.nan_to_num(x))).astype(float)
    posed += root[:, None, None]
    for node in np.unique(links.nodes):
        own = np.flatnonzero(links.nodes == node)
        corners, normals = _mesh([links.points[k, : links.counts[k]] for k in own])
        turns, places = _motion_of(links, own, posed)
        places[~np.isfinite(x).all(axis=1)] = np.nan
        entity = entity_paths.below(entity_paths.FITTED_BODY, str(node))
        mesh = rr.Mesh3D(
            vertex_positions=corners, vertex_normals=normals, albedo_factor=palette.NEUTRAL
        )
        logger.each(entity, [mesh])  # from the first frame on; static, it would be on all timelines
        logger.columns(
            entity,
            rr.Transform3D.columns(
                translation=places.astype(np.float32), mat3x3=turns.astype(np.float32)
            ),
        )


def _mesh(hulls: list[Array]) -> tuple[Array32, Array32]:
    """Corners (3 T, 3) of the triangles of convex hulls, and normals, so that faces are flat."""
    corners, normals = [], []
    for points in hulls:
        hull = ConvexHull(points)
        outwards, own = hull.equations[:, :3], points[hull.simplices]
        turned = np.cross(own[:, 1] - own[:, 0], own[:, 2] - own[:, 0])
        inwards = (turned * outwards).sum(axis=1) < 0
        own[inwards] = own[inwards][:, ::-1]
        corners.append(own.reshape(-1, 3))
        normals.append(np.repeat(outwards, 3, axis=0))
    return np.concatenate(corners).astype(np.float32), np.concatenate(normals).astype(np.float32)


def _motion_of(links: RigidLinks, own: Indices, posed: Array) -> tuple[Array, Array]:
    """Rotation (F, 3, 3) and position (F, 3) of links that move together, by least squares."""
    rest = np.concatenate([links.points[k, : links.counts[k]] for k in own])
    moved = np.concatenate([posed[:, k, : links.counts[k]] for k in own], axis=1)
    centre, centres = rest.mean(axis=0), moved.mean(axis=1)
    u, _, vt = np.linalg.svd(np.swapaxes(moved - centres[:, None], 1, 2) @ (rest - centre))
    u[:, :, 2] *= np.linalg.det(u @ vt)[:, None]
    turns = u @ vt
    return turns, centres - turns @ centre

"""Logging the fitted body: each part a mesh that turns with its joint."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import rerun as rr
from scipy.spatial import ConvexHull

from silpose.core.pose_space import ANGLES
from silpose.core.types import Array, Array32
from silpose.fitting.geometry import geometry_of
from silpose.fitting.kinematics import pose_tree
from silpose.recording import entity_paths, palette
from silpose.recording.frame_logger import FrameLogger
from silpose.silhouette import Body

_LEVEL = 1  # detail of the body that is drawn


class FittedBody:
    """A body whose parts are rigid, each of them a mesh and an entity.

    Parameters
    ----------
    shape : sequence of 10 floats, optional
        Shape coefficients; those of the mean body if not given.
    """

    def __init__(self, shape: Sequence[float] | None = None) -> None:
        self._geometry = geometry_of(Body("convex", _LEVEL, shape=shape))
        self._nodes = {
            entity_paths.below(entity_paths.FITTED_BODY, str(node)): node
            for node in np.unique(self._geometry.nodes).tolist()
        }

    def meshes(self) -> dict[str, rr.Mesh3D]:
        """Mesh of each part, by entity."""
        links, found = self._geometry, {}
        for entity, node in self._nodes.items():
            own = np.flatnonzero(links.nodes == node)
            corners, normals = _mesh([links.points[k, : links.counts[k]] for k in own])
            found[entity] = rr.Mesh3D(
                vertex_positions=corners, vertex_normals=normals, albedo_factor=palette.NEUTRAL
            )
        return found

    def motion(self, x: Array, root: Array, scale: float = 1.0) -> dict[str, tuple[Array, Array]]:
        """Rotation (F, 3, 3) and position (F, 3) of each part, by entity; NaN of a row of NaN.

        Parameters
        ----------
        x : ndarray, shape (F, 55)
        root : ndarray, shape (F, 3)
            Position of the root in the world, metres.
        scale : float, default=1.0
            Size of the person over that of the body.
        """
        angles = np.deg2rad(ANGLES.angles(np.nan_to_num(x)))
        posed = [pose_tree(own, self._geometry) for own in angles]
        turns = scale * np.array([rotations for rotations, _, _ in posed])
        places = scale * np.array([positions for _, positions, _ in posed]) + root[:, None]
        places[~np.isfinite(x).all(axis=1)] = np.nan
        return {entity: (turns[:, k], places[:, k]) for entity, k in self._nodes.items()}


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
    body = FittedBody(shape)
    for entity, mesh in body.meshes().items():
        logger.each(entity, [mesh])  # from the first frame on; static, it would be on all timelines
    for entity, (turns, places) in body.motion(x, root).items():
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

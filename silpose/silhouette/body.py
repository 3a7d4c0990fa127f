"""The mannequin as a body to render: from poses to convex pieces of its surface."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from mannequin import Mannequin
from numpy.typing import ArrayLike
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial.transform import Rotation

from silpose.core.errors import InputError
from silpose.core.skeleton import JOINTS, spine_thirds
from silpose.core.types import Array, Array32

BODIES = ("convex", "wooden")
LEVELS = (0, 1, 2)

BODY_POSE: tuple[str | None, ...] = (
    "left_hip", "right_hip", "chest", "left_knee", "right_knee", "chest",
    "left_ankle", "right_ankle", "chest", None, None,
    "neck", "left_collar", "right_collar", "head",
    "left_shoulder", "right_shoulder", "left_elbow", "right_elbow", "left_wrist", "right_wrist",
)  # fmt: skip
"""SMPL-X body joints 1 to 21, by our joints; the three spine joints share the chest's rotation, and
the toes (None) stay at rest."""

_POSED = {b: joint for b, joint in enumerate(BODY_POSE) if joint is not None}


class Body:
    """A mannequin of one kind and shape.

    Parameters
    ----------
    kind : {"convex", "wooden"}, default="convex"
        Rigid convex links, or a skinned surface: smoother outlines, a hundred times slower.
    level : {0, 1, 2}, default=1
        Level of detail of the convex body: 80, 52 or 22 links.
    shape : sequence of 10 floats, or None, default=None
        SMPL-X shape coefficients, in standard deviations; None is the mean body.

    Raises
    ------
    InputError
        If there is no such kind, level or shape.
    """

    def __init__(
        self, kind: str = "convex", level: int = 1, *, shape: Sequence[float] | None = None
    ) -> None:
        if kind not in BODIES:
            raise InputError(f"there is no body '{kind}'; choose one of {', '.join(BODIES)}")
        if level not in LEVELS:
            raise InputError(f"the body's level of detail must be 0, 1 or 2, not {level}")
        coefficients = None if shape is None else np.asarray(shape, dtype=np.float32)
        if coefficients is not None and coefficients.shape != (10,):
            raise InputError(f"a body's shape must be 10 coefficients, not {coefficients.size}")
        self.kind = kind
        self.level = level
        self.shape = None if coefficients is None else tuple(coefficients.tolist())

    def pieces(self, rotations: ArrayLike) -> Array32:
        """Pose the body and cut its surface into convex pieces.

        The silhouette is the union of the pieces' projections. A piece is the convex hull of a
        rigid link's points, or a triangle of a skinned surface.

        Parameters
        ----------
        rotations : array-like, shape (F, 18, 3, 3)
            Rotation of each joint relative to its parent.

        Returns
        -------
        points : ndarray, shape (F, P, K, 3)
            Metres, the root at the origin: P pieces of K points.
        """
        mannequin, root, links = build_mannequin(self.kind, self.level, self.shape)
        if links is None:
            return self.triangles(rotations)
        pose = _smplx_pose(mannequin, np.asarray(rotations, dtype=float))
        transforms = mannequin.link_transforms(pose).astype(np.float32)
        turns, shifts = transforms[..., :3, :3], transforms[..., None, :3, 3] - root
        return links @ np.swapaxes(turns, -1, -2) + shifts

    def triangles(self, rotations: ArrayLike) -> Array32:
        """Pose the body and cut its surface into its triangles.

        Parameters
        ----------
        rotations : array-like, shape (F, 18, 3, 3)
            Rotation of each joint relative to its parent.

        Returns
        -------
        points : ndarray, shape (F, T, 3, 3)
            Metres, the root at the origin: T triangles.
        """
        mannequin, root, _ = build_mannequin(self.kind, self.level, self.shape)
        pose = _smplx_pose(mannequin, np.asarray(rotations, dtype=float))
        vertices = mannequin.vertices(pose) - root
        return vertices[:, mannequin.faces].astype(np.float32)


@lru_cache(maxsize=8)  # a body takes longer to build than to pose, and many are drawn
def build_mannequin(
    kind: str, level: int, shape: tuple[float, ...] | None
) -> tuple[Mannequin, Array32, Array32 | None]:
    """Mannequin, position of its root at rest, and the points of its links if it has any."""
    mannequin = Mannequin(
        kind,  # type: ignore[arg-type]
        lod=level if kind == "convex" else None,  # type: ignore[arg-type]
        shape=None if shape is None else np.array(shape, dtype=np.float32),
    )
    root = mannequin.joint_transforms(mannequin.rest_pose())[0, :3, 3].astype(np.float32)
    return mannequin, root, None if mannequin.skinned else _points_of_links(mannequin)


def _smplx_pose(mannequin: Mannequin, rotations: Array) -> dict[str, Array32]:
    pose = mannequin.rest_pose(batch_dims=(len(rotations),))
    by_joint = dict(zip(JOINTS, np.moveaxis(rotations, 1, 0), strict=True))
    by_joint["chest"] = spine_thirds(by_joint["chest"])
    turned = np.stack([by_joint[joint] for joint in ("root", *_POSED.values())], axis=1)
    vectors = Rotation.from_matrix(turned.reshape(-1, 3, 3)).as_rotvec()
    vectors = vectors.reshape(*turned.shape[:2], 3)
    pose["pelvis_rotation"][:] = vectors[:, 0]
    pose["body_pose"][:, list(_POSED)] = vectors[:, 1:]
    return pose


def _points_of_links(mannequin: Mannequin) -> Array32:
    """Points of each rigid link in the link's own frame, shape (L, K, 3).

    A link is a closed hull of its own, so it is a connected component of the surface. Links with
    fewer points repeat one, which does not change their hull.
    """
    rest = mannequin.rest_pose()
    vertices = mannequin.vertices(rest)
    faces = mannequin.faces
    edges = (np.ones(len(faces) * 2), (faces[:, [0, 0]].ravel(), faces[:, [1, 2]].ravel()))
    _, link_of = connected_components(coo_array(edges, shape=(len(vertices),) * 2), directed=False)
    longest = np.bincount(link_of).max()
    points = np.empty((link_of.max() + 1, longest, 3), dtype=np.float32)
    for link, transform in enumerate(mannequin.link_transforms(rest)):
        own = (vertices[link_of == link] - transform[:3, 3]) @ transform[:3, :3]
        points[link] = own[np.minimum(np.arange(longest), len(own) - 1)]
    return points

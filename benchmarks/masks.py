"""Masks rendered per second: python benchmarks/masks.py [--fast]."""

import cv2
import numpy as np
from timing import FAST, per_second, report

from silpose.core.pose_space import ANGLES
from silpose.motion import WalkerTakes
from silpose.silhouette import Body, Camera, render

WANTED = 1500  # masks per second of the convex body at level 1
BLOCK = 32  # frames posed at once


def by_triangles(body: Body, camera: Camera, rotations: np.ndarray) -> None:
    """Fill every triangle of the body's surface, as is needed without knowledge of its links."""
    for start in range(0, len(rotations), BLOCK):
        for triangles in camera.project(body.triangles(rotations[start : start + BLOCK])):
            mask = np.zeros((camera.height, camera.width), np.uint8)
            for corners in np.rint(triangles * 16).astype(np.int32):
                cv2.fillConvexPoly(mask, corners, 1, cv2.LINE_8, 4)


if __name__ == "__main__":
    takes = WalkerTakes(test_seconds=20).takes()
    rotations = ANGLES.rotations(ANGLES.from_angles(takes[-1].angles))
    camera = Camera()
    rows = []
    for kind, level, frames in (
        ("convex", 0, 40 if FAST else 300),
        ("convex", 1, 40 if FAST else 300),
        ("convex", 2, 40 if FAST else 300),
        ("wooden", 0, 2 if FAST else 10),
    ):
        body, some = Body(kind, level), rotations[:frames]
        rate = per_second(lambda b=body, r=some: list(render(b, camera, r)), len(some), rounds=3)
        rows.append([f"{kind}, level {level}" if kind == "convex" else kind, f"{rate:,.0f}"])
    body, some = Body("convex", 1), rotations[: 10 if FAST else 60]
    rate = per_second(lambda: by_triangles(body, camera, some), len(some), rounds=1)
    rows.append(["convex, level 1, triangle by triangle", f"{rate:,.0f}"])
    report(
        f"poses of one walk to masks of {camera.height} x {camera.width}, one core; "
        f"wanted at level 1: {WANTED:,}",
        ["body", "masks per second"],
        rows,
    )

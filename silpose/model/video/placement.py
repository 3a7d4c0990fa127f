"""`Placement`: where fitted bodies are, in the picture and on the floor.

A body that the image shows at the scale s, shifted by u pixels from the middle, has k = s g / D
pixels a metre, g and D being the focal length (pixels) and the distance of the camera that bodies
are fitted with. A person m times as large, before a camera of the focal length f, is then at the
depth m f / k, and m u / k aside.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import cv2
import numpy as np
from scipy.ndimage import gaussian_filter1d, median_filter

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.core.skeleton import POINTS, standing_height
from silpose.core.types import Array, Mask
from silpose.evaluation.gait import azimuth_of_camera
from silpose.fitting import (
    SHAPES,
    BodyFitter,
    Fit,
    fitted_joints,
    fitted_silhouettes,
    standing_body_height,
)
from silpose.model.pose_model import PoseModel
from silpose.model.poses import Poses
from silpose.model.video.video_step import VideoStep
from silpose.silhouette.video import MaskedFrame

USUAL_FOCAL_LENGTH = 0.9
"""Focal length of phones and webcams, in longer sides of their pictures."""

_HEIGHTS = (0.5, 2.6)  # metres of a person
_FOCAL_LENGTHS = (0.3, 20.0)
_STEADY = 0.2  # seconds of the filter of depth, which contours tell worst,
_MEDIAN = 5  # frames of the one before it,
_FEWEST = 3  # and from which there is something to filter


@dataclass(frozen=True, eq=False)
class PlacedFit:
    """Bodies of F frames in the world, metres.

    The origin is on the floor below the camera; +X is to the right in the picture, +Y up, +Z from
    the person towards the camera.

    Attributes
    ----------
    joints : ndarray, shape (F, 23, 3)
        In the order of `silpose.core.skeleton.POINTS`; NaN where there is no pose.
    path : ndarray, shape (F, 3)
        The root.
    azimuth : ndarray, shape (F,)
        Of the direction from the person to the camera, degrees, to which headings are relative.
    camera_height : float
        Of the camera above the floor.
    pitch : float
        Degrees by which the camera looks down.
    scale : float
        Size of the person over that of the skeleton.
    skeleton : ndarray, shape (F, 23, 2)
        The joints in the picture, pixels.
    """

    joints: Array
    path: Array
    azimuth: Array
    camera_height: float
    pitch: float
    scale: float
    skeleton: Array


@dataclass(frozen=True, eq=False)
class Placement:
    """From fits to places, for films of one size.

    Attributes
    ----------
    fitter : BodyFitter
        Of the film's size.
    focal : float
        Focal length of the film's camera, pixels.
    body_height : float or None
        Of the person, metres; None takes that of the fitted body.

    See Also
    --------
    Placement.of : Creates one.
    """

    fitter: BodyFitter
    focal: float
    body_height: float | None = None

    @classmethod
    def of(
        cls,
        model: PoseModel,
        shape: tuple[int, ...],
        body_height: float | None = None,
        focal_length: float | None = None,
    ) -> Self:
        """Prepare for a film.

        Parameters
        ----------
        model : PoseModel
            With a fitter.
        shape : tuple of int
            Height and width of the pictures.
        body_height : float, optional
            Height of the person, metres; by default that of the fitted body.
        focal_length : float, optional
            Focal length of the camera, in longer sides of its pictures; by default
            `USUAL_FOCAL_LENGTH`.

        Raises
        ------
        InputError
            If the model has no fitter, or a length is none.
        """
        if model.fitter is None:
            raise InputError("this model has no fitter: train one with fitting.enabled=true")
        check_lengths(body_height, focal_length)
        focal = (focal_length or USUAL_FOCAL_LENGTH) * max(shape)
        return cls(model.fitter.for_size(shape), focal, body_height)

    def height_of(self, fit: Fit) -> float:
        """Height of the person, metres: as given, or that of the fitted body."""
        return self.body_height or standing_body_height(self.fitter, fit.shape)

    def place(self, fit: Fit, frames_per_second: float) -> PlacedFit:
        """Place the bodies of consecutive frames.

        Parameters
        ----------
        fit : Fit
        frames_per_second : float
        """
        size = self.height_of(fit) / standing_body_height(self.fitter, fit.shape)
        scale = self.height_of(fit) / standing_body_height(self.fitter, np.zeros(SHAPES))
        joints, skeleton = fitted_joints(self.fitter, fit)
        view = self.fitter.view
        per_metre = fit.scale * view.focal / view.distance
        depth = _steady(size * self.focal / per_metre, frames_per_second)
        known = np.isfinite(depth)
        aside, below = (fit.shift / self.focal).T
        pitch = np.deg2rad(fit.elevation) - float(np.median(np.arctan(below[known])))
        sine, cosine = np.sin(pitch), np.cos(pitch)
        standing = np.full(len(depth), np.nan)
        standing[known] = scale * standing_height(ANGLES.rotations(fit.x[known]))
        camera_height = float(np.median((standing + depth * (below * cosine + sine))[known]))
        path = np.stack([aside * depth, standing, depth * (below * sine - cosine)], axis=1)
        azimuth = azimuth_of_camera(path, (0.0, camera_height, 0.0))
        turned = np.einsum("fij,fkj->fki", turns(azimuth), joints)
        return PlacedFit(
            path[:, None] + size * turned, path, azimuth, camera_height, float(np.rad2deg(pitch)),
            scale, skeleton,
        )  # fmt: skip

    def outlines(self, fit: Fit) -> list[Array]:
        """Trace the outline (N, 2) of each fitted body in the picture, pixels."""
        return [_outline(silhouette) for silhouette in fitted_silhouettes(self.fitter, fit)]

    def step(
        self, frame: MaskedFrame, poses: Poses, *, latency: float | None = None, dropped: int = 0
    ) -> VideoStep:
        """Put together what is known of one frame of a live source.

        Parameters
        ----------
        frame : MaskedFrame
        poses : Poses
            Of this frame, fitted.
        latency : float, optional
            Seconds from the picture to the pose.
        dropped : int, default=0
            Frames that were dropped before this one.
        """
        skeleton = np.full((len(POINTS), 2), np.nan)
        outline, place, azimuth, scale = np.empty((0, 2)), np.full(3, np.nan), 0.0, 1.0
        if poses.fit is not None and np.isfinite(poses.fit.scale).all():
            placed = self.place(poses.fit, 1.0)
            skeleton, place, azimuth = placed.skeleton[0], placed.path[0], placed.azimuth[0]
            scale, (outline,) = placed.scale, self.outlines(poses.fit)
        return VideoStep(
            frame.index, frame.time, frame.picture, frame.mask, frame.state, poses, skeleton,
            outline, place, float(azimuth), scale, latency, dropped,
        )  # fmt: skip


def check_lengths(body_height: float | None, focal_length: float | None) -> None:
    """Refuse lengths, as of `Placement.of`, that no person and no camera has."""
    for name, value, (low, high), unit in (
        ("body_height", body_height, _HEIGHTS, "metres, such as 1.75"),
        ("focal_length", focal_length, _FOCAL_LENGTHS, "longer sides of a picture, such as 0.9"),
    ):
        if value is not None and not low <= value <= high:
            raise InputError(
                f"silhouette.{name} must be from {low:g} to {high:g} {unit}, not {value:g}"
            )


def _steady(depth: Array, frames_per_second: float) -> Array:
    """Filter the depth (F,) of a person over time, without regard to gaps, which stay."""
    known = np.isfinite(depth)
    if known.sum() < _FEWEST:
        return depth
    frames = np.arange(len(depth))
    filled = np.interp(frames, frames[known], depth[known])
    steady = gaussian_filter1d(
        median_filter(filled, _MEDIAN, mode="nearest"), _STEADY * frames_per_second, mode="nearest"
    )
    return np.where(known, steady, np.nan)


def turns(azimuth: Array) -> Array:
    """Rotations (F, 3, 3) about the vertical by angles in degrees, from +Z to +X."""
    sine, cosine = np.sin(np.deg2rad(azimuth)), np.cos(np.deg2rad(azimuth))
    zero, one = np.zeros_like(sine), np.ones_like(sine)
    rows = [[cosine, zero, sine], [zero, one, zero], [-sine, zero, cosine]]
    return np.moveaxis(np.array(rows), -1, 0)


def _outline(silhouette: Mask) -> Array:
    lines, _ = cv2.findContours(silhouette, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_TC89_L1)
    if not lines:
        return np.empty((0, 2))
    return np.asarray(max(lines, key=cv2.contourArea)[:, 0], float)

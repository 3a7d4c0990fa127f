"""Logging the camera and the masks."""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np
import rerun as rr
from numpy.typing import NDArray

from silpose.core.types import Array, Mask
from silpose.recording import entity_paths, palette
from silpose.recording.frame_logger import FrameLogger
from silpose.recording.layout import Window
from silpose.silhouette import Camera

Masks = Sequence[Mask] | NDArray[np.uint8]
"""One mask (H, W) of 0 and 1 per frame."""


def window_of(masks: Masks) -> Window | None:
    """Where people are in any of the masks, with a margin; None if there are no masks."""
    boxes = [cv2.boundingRect(np.asarray(mask != 0).view(np.uint8)) for mask in masks if mask.any()]
    if not boxes:
        return None
    left, top, width, height = np.array(boxes, dtype=float).T
    margin = 0.08 * height.max()
    ends = left.min(), (left + width).max(), top.min(), (top + height).max()
    return ends[0] - margin, ends[1] + margin, ends[2] - margin, ends[3] + margin


def log_camera(logger: FrameLogger, camera: Camera, aim: Array) -> None:
    """Log a camera that looks at ``aim (F, 3)``, so that the viewer projects what is in 3D."""
    logger.static(
        entity_paths.CAMERA,
        rr.Pinhole(
            focal_length=camera.focal_pixels,
            width=camera.width,
            height=camera.height,
            camera_xyz=rr.ViewCoordinates.RDF,
            image_plane_distance=1.0,
            color=palette.NEUTRAL,
        ),
    )
    logger.static(entity_paths.CAMERA, rr.Transform3D.from_fields(mat3x3=camera.orientation))
    logger.columns(entity_paths.CAMERA, rr.Transform3D.columns(translation=aim + camera.position))


def log_image_size(logger: FrameLogger, width: int, height: int) -> None:
    """Log how large the images of an unknown camera are, pixels."""
    logger.static(entity_paths.CAMERA, rr.Pinhole(focal_length=height, width=width, height=height))


def log_masks(logger: FrameLogger, masks: Masks) -> None:
    """Log the mask of each frame."""
    classes = [(0, "background", palette.CLEAR), (1, "person", palette.MASK)]
    logger.static(entity_paths.MASK, rr.AnnotationContext(classes))
    logger.each(entity_paths.MASK, (rr.SegmentationImage(mask) for mask in masks))


def log_masks_alone(logger: FrameLogger, masks: Masks) -> None:
    """Log the mask of each frame, all of one size, and who is in it, where no camera is logged."""
    height, width = masks[0].shape
    log_image_size(logger, width, height)
    box = rr.Boxes2D(mins=[0, 0], sizes=[width, height], colors=palette.NEUTRAL)
    logger.static(entity_paths.FRAME, box)
    log_masks(logger, masks)
    seen = ["person" if mask.any() else "blank" for mask in masks]
    logger.states(entity_paths.SEEN, seen, palette.SEEN)

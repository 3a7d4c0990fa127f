"""Masks: rendered from a posed body in front of a camera, degraded, or of one's own.

Poses come from `silpose.motion`; `silpose.dataset` pairs them with their masks, and
`silpose.descriptor` describes masks of any origin.
"""

from silpose.silhouette.blank_masks import is_blank, visible
from silpose.silhouette.body import BODIES, LEVELS, Body
from silpose.silhouette.camera import Camera
from silpose.silhouette.degradations import (
    DEGRADATIONS,
    SEGMENTATION_FAULTS,
    contour_damage,
    degrade,
)
from silpose.silhouette.foreign import FOREIGN, foreign_shape
from silpose.silhouette.masks import MaskReader, MaskSequence, MaskSource, read_masks
from silpose.silhouette.random_degradation import Degradation, Degrader
from silpose.silhouette.render import fill_pieces, render
from silpose.silhouette.rigid_links import RigidLinks

__all__ = [
    "BODIES",
    "DEGRADATIONS",
    "FOREIGN",
    "LEVELS",
    "SEGMENTATION_FAULTS",
    "Body",
    "Camera",
    "Degradation",
    "Degrader",
    "MaskReader",
    "MaskSequence",
    "MaskSource",
    "RigidLinks",
    "contour_damage",
    "degrade",
    "fill_pieces",
    "foreign_shape",
    "is_blank",
    "read_masks",
    "render",
    "visible",
]

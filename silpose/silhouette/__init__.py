"""Where masks come from: a posed body before a camera, or image files."""

from silpose.silhouette.body import BODIES, LEVELS, Body
from silpose.silhouette.camera import Camera
from silpose.silhouette.degradations import DEGRADATIONS, contour_damage, degrade
from silpose.silhouette.mask_files import mask_files, mask_names, read_mask, read_masks
from silpose.silhouette.random_degradation import Degradation
from silpose.silhouette.render import render

__all__ = [
    "BODIES",
    "DEGRADATIONS",
    "LEVELS",
    "Body",
    "Camera",
    "Degradation",
    "contour_damage",
    "degrade",
    "mask_files",
    "mask_names",
    "read_mask",
    "read_masks",
    "render",
]

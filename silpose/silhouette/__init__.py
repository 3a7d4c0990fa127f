"""Where masks come from: a posed body before a camera, or image files."""

from silpose.silhouette.body import KINDS, LEVELS, Body
from silpose.silhouette.camera import Camera
from silpose.silhouette.files import mask_files, read_mask, read_masks
from silpose.silhouette.render import render

__all__ = ["KINDS", "LEVELS", "Body", "Camera", "mask_files", "read_mask", "read_masks", "render"]

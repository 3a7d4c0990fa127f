"""Masks of one's own, of any origin and encoding."""

from silpose.silhouette.masks.folders import image_files
from silpose.silhouette.masks.mask_reader import MaskReader
from silpose.silhouette.masks.mask_source import MaskSource
from silpose.silhouette.masks.numbered_frames import NumberedFrames
from silpose.silhouette.masks.other_formats import why_no_masks
from silpose.silhouette.masks.packed_mask import PackedMask
from silpose.silhouette.masks.read import read_masks
from silpose.silhouette.masks.sequence import MaskSequence

__all__ = [
    "MaskReader",
    "MaskSequence",
    "MaskSource",
    "NumberedFrames",
    "PackedMask",
    "image_files",
    "read_masks",
    "why_no_masks",
]

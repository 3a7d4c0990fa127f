"""Masks of a person in real pictures: films, cameras and streams, without their background."""

from silpose.silhouette.video.clock import times_of_numbers
from silpose.silhouette.video.frame import Frame
from silpose.silhouette.video.masked_frame import MaskedFrame
from silpose.silhouette.video.open_source import open_source
from silpose.silhouette.video.segmenter import Segmenter
from silpose.silhouette.video.video_masks import VideoMasks
from silpose.silhouette.video.whole_clip import doubts_of, even_times

__all__ = [
    "Frame",
    "MaskedFrame",
    "Segmenter",
    "VideoMasks",
    "doubts_of",
    "even_times",
    "open_source",
    "times_of_numbers",
]

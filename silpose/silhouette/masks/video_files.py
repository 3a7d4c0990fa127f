"""Pictures of a video."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

import cv2
import numpy as np

from silpose.core.errors import InputError
from silpose.silhouette.masks.decoder_errors import DecoderErrors
from silpose.silhouette.masks.film_headers import BARE, cut_off, known_rate
from silpose.silhouette.masks.image_files import Animation
from silpose.silhouette.masks.opencv_log import silent_opencv
from silpose.silhouette.masks.picture import Picture, compact

VIDEOS = (
    *(".mp4", ".m4v", ".mov", ".avi", ".mkv", ".webm", ".mpg", ".mpeg", ".wmv", ".flv"),
    *(".ts", ".mts", ".m2ts", ".3gp", ".ogv"),
)
"""Suffixes of videos."""

os.environ.setdefault("OPENCV_FFMPEG_LOGLEVEL", "-8")  # what is wrong is said in one sentence

_UNEVEN = 2.0  # intervals by which frames may be off an even rate


def read_video(file: Path) -> Animation:
    """Read all frames of a video, with its rate.

    Raises
    ------
    InputError
        If it is no video that can be read, or has no frames.
    """
    # An absolute path, since FFmpeg takes what is before a colon for a protocol; its backend
    # alone, since others take a percent sign for a numbered series of images.
    with silent_opencv():
        video = cv2.VideoCapture(str(file.absolute()), cv2.CAP_FFMPEG)
    if not video.isOpened():
        raise InputError(
            f"'{file}' is no video that can be read: give a video, an image or a folder of masks"
        )
    told, announced = video.get(cv2.CAP_PROP_FPS), int(video.get(cv2.CAP_PROP_FRAME_COUNT))
    rate = None if file.suffix.lower() in BARE else known_rate(told)
    errors = DecoderErrors(file)
    pictures: list[Picture] = []
    stamps: list[float] = []
    while (read := video.read())[0]:
        name = f"frame {len(pictures)}"
        pictures.append(compact(Picture(read[1][:, :, ::-1], name, lossy=True)))
        stamps.append(video.get(cv2.CAP_PROP_POS_MSEC) / 1000)
    video.release()
    damage = errors.doubt()
    if not pictures:
        raise InputError(f"the video '{file}' has no frames: record it anew")
    lasting = (stamps[-1] - stamps[0]) * told
    cut = cut_off(file, len(pictures), announced, lasting)
    doubts = (cut or damage, _uneven(file, stamps, rate))
    return Animation(pictures, rate, tuple(doubt for doubt in doubts if doubt))


def _uneven(file: Path, stamps: Sequence[float], rate: float | None) -> str:
    """Say that frames do not follow each other at the rate that is told."""
    if rate is None or not (np.diff(stamps) > 0).all():  # a clock that jumps tells nothing
        return ""
    late = np.array(stamps) - np.arange(len(stamps)) / rate
    if np.ptp(late) <= _UNEVEN / rate:
        return ""
    return (
        f"the frames of '{file}' come at uneven times, and are taken for {rate:.4g} frames per "
        "second: if their times matter, convert it, as by ffmpeg -i IN -fps_mode cfr OUT.mp4"
    )

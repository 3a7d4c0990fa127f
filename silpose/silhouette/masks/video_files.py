"""Pictures of a video."""

from __future__ import annotations

import os
from pathlib import Path

import cv2

from silpose.core.errors import InputError
from silpose.silhouette.masks.image_files import Animation
from silpose.silhouette.masks.opencv_log import silent_opencv
from silpose.silhouette.masks.picture import Picture, compact

VIDEOS = (
    *(".mp4", ".m4v", ".mov", ".avi", ".mkv", ".webm", ".mpg", ".mpeg", ".wmv", ".flv"),
    *(".ts", ".mts", ".m2ts", ".3gp", ".ogv"),
)
"""Suffixes of videos."""

os.environ.setdefault("OPENCV_FFMPEG_LOGLEVEL", "-8")  # what is wrong is said in one sentence

_FASTEST = 1000  # frames per second; containers without a rate tell their clock's


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
    rate = video.get(cv2.CAP_PROP_FPS)
    pictures: list[Picture] = []
    while (read := video.read())[0]:
        name = f"frame {len(pictures)}"
        pictures.append(compact(Picture(read[1][:, :, ::-1], name, lossy=True)))
    video.release()
    if not pictures:
        raise InputError(f"the video '{file}' has no frames: record it anew")
    return Animation(pictures, rate if 0 < rate < _FASTEST else None)

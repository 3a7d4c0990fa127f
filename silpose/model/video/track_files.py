"""A track as files: a table, arrays, and what animation and biomechanics programs read."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np

from silpose.core.pose_space import ANGLES
from silpose.model.pose_table import Column, columns_csv
from silpose.model.video.trc import write_trc
from silpose.model.video.video_track import VideoTrack


def track_files(track: VideoTrack) -> Mapping[str, Callable[[Path], None]]:
    """Functions that write a track to a path, by the names of the files.

    ``track.csv`` is as `track_columns`, ``track.npz`` holds the same as arrays and covariances,
    ``track.trc`` the joints; ``track.bvh``, of tracks with a pose, holds its frames at an even
    rate, without gaps.
    """
    files: dict[str, Callable[[Path], None]] = {
        "track.csv": partial(_write_table, track),
        "track.npz": partial(_write_arrays, track),
        "track.trc": partial(_write_joints, track),
    }
    if track.poses.known.any() and len(track) > 1:
        files["track.bvh"] = partial(_write_motion, track)
    return files


def track_columns(track: VideoTrack) -> Mapping[str, Column]:
    """Lay a track out as columns, each of F values.

    Returns
    -------
    columns : mapping of str to sequence
        ``frame`` (its number in the source), ``time`` (seconds), ``state`` of the pose, ``mask``
        (state of the mask), ``cut`` (1 where the frame cuts the person), ``confidence``, ``iou``,
        ``heading_deg`` relative to the camera, the other angles in degrees, and all joints in the
        world, metres.
    """
    poses = track.poses
    assert poses.iou is not None and poses.facts is not None
    columns: dict[str, Column] = {
        "frame": [str(index) for index in track.index],
        "time": poses.time,
        "state": poses.state,
        "mask": track.seen,
        "cut": poses.facts.cut.astype(np.int8),
        "confidence": poses.confidence,
        "iou": poses.iou,
        "heading_deg": poses.heading,
    }
    columns |= {f"{c}_deg": poses.x[:, 2 + k] for k, c in enumerate(poses.space.columns[2:])}
    for j, joint in enumerate(poses.space.joint_names):
        columns |= {f"{joint}_{axis}_m": track.joints[:, j, k] for k, axis in enumerate("xyz")}
    return columns


def _write_table(track: VideoTrack, file: Path) -> None:
    text = columns_csv(track_columns(track), ("frame", "time"))
    file.write_text(text, encoding="utf-8", newline="")


def _write_arrays(track: VideoTrack, file: Path) -> None:
    poses = track.poses
    arrays = {
        "frame": track.index, "time": poses.time, "state": np.array(poses.state),
        "mask": np.array(track.seen), "confidence": poses.confidence, "iou": poses.iou,
        "x": poses.x, "columns": np.array(poses.space.columns), "angles": track.angles,
        "angle_names": np.array(poses.space.angle_names), "joints": track.joints,
        "joint_names": np.array(poses.space.joint_names), "path": track.path,
        "azimuth": track.azimuth, "scale": track.scale, "camera_height": track.camera_height,
        "body_height": track.body_height, "body_height_given": track.height_given,
    }  # fmt: skip
    if track.covariance is not None:
        arrays["covariance"] = track.covariance
    with file.open("wb") as opened:
        np.savez_compressed(opened, **arrays)  # type: ignore[arg-type]


def _write_joints(track: VideoTrack, file: Path) -> None:
    poses, names = track.poses, track.poses.space.joint_names
    write_trc(file, "track.trc", track.joints, names, poses.time, poses.frames_per_second)


def _write_motion(track: VideoTrack, file: Path) -> None:
    turned = replace(track.poses, x=ANGLES.from_angles(track.angles))
    turned.save_bvh(file, path=track.path, scale=track.size)

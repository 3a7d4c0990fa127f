"""Poses from a folder of BVH motion capture files."""

from __future__ import annotations

import re
import shutil
import tempfile
import warnings
from pathlib import Path

import numpy as np
import pybvh

from silpose.errors import InputError
from silpose.motion.retarget import retarget
from silpose.motion.track import Motion


class BvhFolder:
    """Takes from every BVH file in a folder and its subfolders.

    Parameters
    ----------
    root : str or Path
        The folder. Files end in ``.bvh``, have +Y up, and a skeleton of a kind listed in
        `silpose.motion.source_skeleton.SOURCE_JOINTS`.
    frames_per_second : float
        To which the takes are resampled.
    performer : str
        Regular expression on a file's stem; its first group names the performer. Where it does
        not match, the name of the file's folder does.
    """

    def __init__(
        self, root: str | Path, frames_per_second: float = 15.0, performer: str = r"^(\d+)_"
    ) -> None:
        if not frames_per_second > 0:
            raise InputError(
                f"motion.frames_per_second must be a positive number, not {frames_per_second}"
            )
        try:
            groups = re.compile(performer).groups
        except re.error as error:
            raise InputError(
                f"motion.performer '{performer}' is no regular expression: {error}"
            ) from error
        if groups < 1:
            raise InputError(
                f"motion.performer '{performer}' needs a group in parentheses around the "
                "performer's name"
            )
        self.root = root
        self.frames_per_second = frames_per_second
        self.performer = performer

    def takes(self) -> list[Motion]:
        """Read and retarget all files, sorted by file name.

        Returns
        -------
        takes : list of Motion
            Each named by its file's path in the folder, without the ending.

        Raises
        ------
        InputError
            If the folder or a file in it cannot be used; the message names it.
        """
        return [self._take(file) for file in self._files()]

    def _files(self) -> list[Path]:
        root = Path(self.root)
        if not root.is_dir():
            raise InputError(f"{root}: no such folder; give the one that holds your BVH files")
        files = [f for f in root.rglob("*") if f.suffix.lower() == ".bvh" and f.is_file()]
        if not files:
            raise InputError(f"{root}: no .bvh files in this folder or its subfolders")
        return sorted(files, key=lambda file: (file.name, file))

    def _take(self, file: Path) -> Motion:
        angles, position = retarget(read_bvh(file), self.frames_per_second, str(file))
        found = re.search(self.performer, file.stem)
        return Motion(
            name=file.relative_to(self.root).with_suffix("").as_posix(),
            performer=(found and found.group(1)) or file.resolve().parent.name,
            frames_per_second=float(self.frames_per_second),
            angles=angles,
            root_position=position,
        )


def read_bvh(file: str | Path) -> pybvh.Bvh:
    """Read a BVH file and check that its motion can be used.

    Parameters
    ----------
    file : str or Path

    Returns
    -------
    bvh : pybvh.Bvh
        With +Y up.

    Raises
    ------
    InputError
        If it is no BVH file, is truncated, has no frames, no frame time or a number that is
        not finite.
    """
    file = Path(file)
    _check_header(file)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # the empty motion has its own message below
        try:
            bvh = _parse(file)
        except (ValueError, IndexError, OSError) as error:
            reason = str(error).splitlines()[0] if str(error) else type(error).__name__
            raise InputError(
                f"{file}: cannot be read as BVH, it may be truncated or damaged ({reason}); "
                "export or download it again"
            ) from error
    offsets = np.array([node.offset for node in bvh.nodes])
    if not np.isfinite(offsets).all():
        raise InputError(f"{file}: an OFFSET is not a finite number; export the file again")
    for values in (bvh.root_pos, bvh.joint_angles.reshape(bvh.frame_count, -1)):
        bad = np.flatnonzero(~np.isfinite(values).all(axis=1))
        if len(bad):
            raise InputError(
                f"{file}: frame {bad[0]} holds a number that is not finite; remove such frames "
                "or export the file again"
            )
    return bvh


def _check_header(file: Path) -> None:
    """Judge the number of frames and the frame time, whose absence pybvh does not tell apart."""
    try:
        header = file.read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        raise InputError(f"{file}: cannot be read ({error.strerror})") from error
    if "HIERARCHY" not in header or "ROOT" not in header:
        raise InputError(f"{file}: is no BVH file (no HIERARCHY with a ROOT); remove or replace it")
    frames = re.search(r"^\s*Frames:\s*(\S+)", header, re.MULTILINE)
    seconds = re.search(r"^\s*Frame Time:\s*(\S+)", header, re.MULTILINE)
    if frames is None or seconds is None:
        raise InputError(
            f"{file}: has no 'Frames:' or no 'Frame Time:' line, it may be truncated; export or "
            "download it again"
        )
    if _number(frames[1]) == 0:
        raise InputError(f"{file}: has no motion frames; export it with its motion")
    if not 0 < _number(seconds[1]) < np.inf:
        raise InputError(
            f"{file}: its frame time is '{seconds[1]}'; it must be a positive number of seconds"
        )


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        return float("nan")


def _parse(file: Path) -> pybvh.Bvh:
    if file.suffix == ".bvh":
        return pybvh.read_bvh_file(file, world_up="+y")
    with tempfile.TemporaryDirectory() as folder:  # pybvh insists on a small-letter ending
        copy = Path(folder) / "take.bvh"
        shutil.copyfile(file, copy)
        return pybvh.read_bvh_file(copy, world_up="+y")

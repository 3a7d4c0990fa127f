"""Motion from a folder of motion capture files."""

from __future__ import annotations

import re
import warnings
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

from silpose.core.errors import InputError
from silpose.core.progress import bar
from silpose.core.skeleton import near_singularity
from silpose.motion.capture.amass import amass_take
from silpose.motion.capture.bvh import bvh_take
from silpose.motion.capture.joint_names import Names, common_names
from silpose.motion.motion import Motion
from silpose.motion.motion_source import MotionSource

FORMATS = ("bvh", "npz")


class MotionFolder(MotionSource):
    r"""Motion capture: every file in a folder and its subfolders is a take.

    Parameters
    ----------
    root : str or Path
        The folder; its files may have different skeletons.
    frames_per_second : float, default=15.0
        Frame rate to which takes are resampled.
    performer : str, default=r"(?:^|/)(\d+)_[^/]*$"
        Regular expression on a file's path below root, without its ending; its first group is the
        performer. Where it does not match, the performer is the name of the file's folder.
    formats : sequence of {"bvh", "npz"}, default=("bvh",)
        Endings of the files to read: BVH with +Y up, AMASS.
    strict : bool, default=False
        Whether a file that cannot be used is an error. If not, it is left out with a warning, and
        only a folder without any usable file is an error.
    joints : mapping of str to sequence of str or None, default=None
        Names of joints in BVH files, such as ``{"left_elbow": ["NAME"]}``, in place of those that
        are known (``silpose/motion/capture/joint_names.yaml``).

    Raises
    ------
    InputError
        If a parameter cannot be used.
    """

    name = "folder"

    def __init__(
        self,
        root: str | Path,
        *,
        frames_per_second: float = 15.0,
        performer: str = r"(?:^|/)(\d+)_[^/]*$",
        formats: Sequence[str] = ("bvh",),
        strict: bool = False,
        joints: Names | None = None,
    ) -> None:
        if not 0 < frames_per_second < float("inf"):
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
        if unknown := [name for name in formats if name not in FORMATS] or not formats:
            raise InputError(f"motion.formats must be some of {', '.join(FORMATS)}, not {unknown}")
        self.root = Path(root)
        self.frames_per_second = float(frames_per_second)
        self.performer = performer
        self.formats = formats
        self.strict = strict
        self.joints = joints or {}
        if extra := sorted(set(self.joints) - set(common_names())):
            raise InputError(
                f"motion.joints has no joint '{extra[0]}'; joints are {', '.join(common_names())}"
            )

    def files(self) -> list[Path]:
        """List the files that are read, sorted by name."""
        if not self.root.is_dir():
            raise InputError(f"{self.root}: no such folder; give one that holds motion capture")
        endings = [f".{name}" for name in self.formats]
        files = [f for f in self.root.rglob("*") if f.suffix.lower() in endings and f.is_file()]
        if not files:
            raise InputError(
                f"{self.root}: no {' or '.join(endings)} files in this folder or its subfolders"
            )
        return sorted(files, key=lambda file: (file.name, file))

    def read(self) -> list[Motion]:
        """Read and retarget all files.

        Returns
        -------
        takes : list of Motion
            Each named by its file's path in the folder, without the ending.

        Raises
        ------
        InputError
            If the folder has no file that can be used, or one that cannot and `strict` is set;
            the message names it.
        """
        files = self.files()
        stems = Counter(file.with_suffix("") for file in files)
        takes, failed = [], []
        with bar("motion", len(files)) as advance:
            for file in files:
                try:
                    takes.append(self._take(file, whole_name=stems[file.with_suffix("")] > 1))
                except InputError as error:
                    failed.append(error)
                    if self.strict:
                        break
                advance(1)
        if failed and (self.strict or not takes):
            others = len(files) - 1
            also = f" (and none of the other {others} files can be used)" if others else ""
            raise InputError(f"{failed[0]}{'' if self.strict else also}")
        for reason in failed:
            warnings.warn(f"left out {reason}", stacklevel=2)
        self._report_singularities(takes)
        return takes

    def _take(self, file: Path, whole_name: bool) -> Motion:
        if file.suffix.lower() == ".bvh":
            angles, position = bvh_take(file, self.frames_per_second, self._names)
        else:
            angles, position = amass_take(file, self.frames_per_second)
        path = file.relative_to(self.root)
        stem = path.with_suffix("").as_posix()
        found = re.search(self.performer, stem)
        return Motion(
            name=path.as_posix() if whole_name else stem,
            performer=(found and found.group(1)) or file.resolve().parent.name,
            frames_per_second=self.frames_per_second,
            angles=angles,
            root_position=position,
        )

    @property
    def _names(self) -> Names:
        return {**common_names(), **self.joints}

    def _report_singularities(self, takes: Sequence[Motion]) -> None:
        for take in takes:
            near = near_singularity(take.angles)
            if near:
                joints = ", ".join(f"{joint} in {frames} frames" for joint, frames in near.items())
                warnings.warn(
                    f"take '{take.name}' comes near a singularity of Euler angles: {joints}; their "
                    "angles may jump there",
                    stacklevel=3,
                )

"""Motion from a folder of motion capture files."""

from __future__ import annotations

import re
import warnings
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

from silpose.core.errors import InputError
from silpose.core.progress import bar
from silpose.core.readable import readable
from silpose.core.skeleton import near_singularity
from silpose.motion.capture.folder_files import motion_files
from silpose.motion.capture.formats import FORMATS
from silpose.motion.capture.naming import Names, check_given
from silpose.motion.capture.options import CaptureOptions
from silpose.motion.capture.take import CapturedTake, read_take
from silpose.motion.motion import Motion
from silpose.motion.motion_source import MotionSource


class MotionFolder(MotionSource):
    r"""Motion capture: every file in a folder and its subfolders is a take.

    Parameters
    ----------
    root : str or Path
        The folder; its files may have different skeletons. Or a single file, of any format.
    frames_per_second : float, default=15.0
        Frame rate to which takes are resampled.
    performer : str, default=r"(?:^|/)(\d+)_[^/]*$"
        Regular expression on a file's path below root, without its ending; its first group is the
        performer. Where it does not match, the performer is the name of the file's folder.
    formats : sequence of {"bvh", "amc", "npz"}, default=("bvh", "amc")
        Endings of the files to read: BVH, AMC with an ASF, AMASS.
    strict : bool, default=False
        Whether a file that cannot be used is an error. If not, it is left out with a warning, and
        only a folder without any usable file is an error.
    joints : mapping of str to sequence of str or None, default=None
        Names of joints in the files, such as ``{"left_elbow": ["NAME"]}``, in place of those that
        are recognised.
    frame_rate : float or None, default=None
        Frame rate of the files, frames per second, in place of what they say.
    up : {"auto", "x", "y", "z", "-x", "-y", "-z"}, default="auto"
        Axis of the files that points up; "auto" finds it from the format and the motion.
    mirror : bool, default=False
        Whether files whose axes are left-handed, or whose left and right are exchanged, are
        mirrored. If not, they are refused.

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
        formats: Sequence[str] = ("bvh", "amc"),
        strict: bool = False,
        joints: Names | None = None,
        frame_rate: float | None = None,
        up: str = "auto",
        mirror: bool = False,
    ) -> None:
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
        self.frame_rate, self.up, self.mirror = frame_rate, up, mirror
        self._options = CaptureOptions(
            frames_per_second=self.frames_per_second,
            frame_rate=frame_rate,
            up=up,
            mirror=mirror,
            joints=check_given(joints),
        )

    def files(self) -> list[Path]:
        """List the files that are read, sorted by name."""
        return motion_files(self.root, self.formats)

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
        notes: dict[str, list[Path]] = {}
        with bar("motion", len(files)) as advance:
            for file in files:
                try:
                    captured = self.captured(file)
                    whole_name = stems[file.with_suffix("")] > 1
                    takes.append(self._take(file, captured, whole_name))
                    for note in captured.report.notes:
                        notes.setdefault(note, []).append(file)
                except InputError as error:
                    failed.append(error)
                    if self.strict:
                        break
                advance(1)
        if failed and (self.strict or not takes):
            more = len(files) - 1
            also = f" (and none of the other {more} files can be used)" if more else ""
            raise InputError(f"{failed[0]}{'' if self.strict else also}")
        for reason in failed:
            warnings.warn(f"left out {reason}", stacklevel=2)
        for note, noted in notes.items():
            others = f" and {more} more file{'s' * (more > 1)}" if (more := len(noted) - 1) else ""
            warnings.warn(f"{noted[0]}{others}: {note}", stacklevel=2)
        self._report_singularities(takes)
        return takes

    def _take(self, file: Path, captured: CapturedTake, whole_name: bool) -> Motion:
        path = file.relative_to(self.root if self.root.is_dir() else self.root.parent)
        stem = readable(path.with_suffix("").as_posix())
        found = re.search(self.performer, stem)
        return Motion(
            name=readable(path.as_posix()) if whole_name else stem,
            performer=(found and found.group(1)) or readable(file.resolve().parent.name),
            frames_per_second=self.frames_per_second,
            angles=captured.angles,
            root_position=captured.root_position,
        )

    def captured(self, file: Path) -> CapturedTake:
        """Read one of the files, with a report of what was understood.

        Raises
        ------
        InputError
            If it cannot be used.
        """
        return read_take(file, self._options)

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

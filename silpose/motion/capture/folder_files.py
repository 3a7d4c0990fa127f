"""The motion capture files of a folder, among whatever else lies there."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

from silpose.core.errors import InputError
from silpose.motion.capture.formats import FORMATS, holds_motion

_REMEDIES = dict.fromkeys(
    ("fbx", "c3d", "trc", "glb", "gltf", "blend", "mvnx"), "export them as BVH"
)
_REMEDIES |= dict.fromkeys(("zip", "gz", "tgz", "7z", "rar", "tar", "bz2", "xz"), "unpack them")
_REMEDIES |= dict.fromkeys(("pkl", "npy", "pt"), "save their poses, trans and fps by np.savez")
_CHOICE = {"bvh": "motion=bvh", "amc": "motion=bvh", "npz": "motion=amass"}


def motion_files(root: Path, formats: Sequence[str]) -> list[Path]:
    """List the files of motion below a folder, sorted by name.

    Hidden files and folders, among them those that macOS puts into archives, are skipped, and so
    are ``.npz`` archives that hold no motion, such as AMASS's ``shape.npz`` and ``…_stagei.npz``.

    Parameters
    ----------
    root : Path
        A folder, or a single file of any format that can be read.
    formats : sequence of str
        Endings, without the dot; case does not matter.

    Returns
    -------
    files : list of Path

    Raises
    ------
    InputError
        If there are none; it says what there is instead.
    """
    if root.is_file():
        if _ending(root) not in FORMATS:
            raise InputError(f"{root}: {_refusal(_ending(root))}")
        return [root]
    if not root.is_dir():
        raise InputError(f"{root}: no such folder; give one that holds motion capture")
    every = list(_walk(root))
    wanted = [file for file in every if _ending(file) in formats]
    files = [file for file in wanted if _ending(file) != "npz" or holds_motion(file)]
    if not files:
        kinds = " or ".join(f".{name}" for name in formats)
        raise InputError(
            f"{root}: no {kinds} files in this folder or its subfolders{_instead(every, formats)}"
        )
    return sorted(files, key=lambda file: (file.name, file))


def _ending(file: Path) -> str:
    return file.suffix.lower().removeprefix(".")


def _walk(root: Path) -> Iterator[Path]:
    """Give all files that are not hidden; links to folders elsewhere are followed, once each."""
    whole, visited = root.resolve(), set()
    for folder, below, names in os.walk(root, followlinks=True):
        place = Path(folder).resolve()
        linked = Path(folder).is_symlink() and Path(folder) != root
        if place in visited or (linked and place.is_relative_to(whole)):
            below.clear()
            continue
        visited.add(place)
        below[:] = sorted(n for n in below if not n.startswith(".") and n != "__MACOSX")
        for name in names:
            file = Path(folder, name)
            if not name.startswith(".") and file.is_file():
                yield file


def _refusal(ending: str) -> str:
    """Say why a file of a certain ending is not read, and what to do."""
    if ending == "asf":
        return "is a skeleton without motion; give its .amc file, or the folder of both"
    readable = ", ".join(f".{name}" for name in FORMATS)
    remedy = _REMEDIES.get(ending, "export it as BVH").replace("them", "it").replace("their", "its")
    return f"is no motion capture that can be read ({readable}); {remedy}"


def _instead(files: Sequence[Path], formats: Sequence[str]) -> str:
    """Continue the message that there are no files: by what there is."""
    counts = Counter(_ending(file) for file in files)
    for name in FORMATS:
        if counts[name] and name not in formats:
            return (
                f"; its {counts[name]} .{name} files are read by {_CHOICE[name]} "
                f"(Python: formats=['{name}'])"
            )
    if counts["npz"] and "npz" in formats:
        return f"; its {counts['npz']} .npz files hold no motion: they have no 'poses'"
    if counts["asf"] and "amc" in formats:
        return "; an .asf file is a skeleton without motion: put its .amc files beside it"
    for name, remedy in _REMEDIES.items():
        if counts[name]:
            return f"; its {counts[name]} .{name} files cannot be read as they are: {remedy}"
    return "; give a folder that holds motion capture"

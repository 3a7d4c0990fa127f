"""Trees of masks: folders of folders, of which each with masks is one take."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from dataclasses import dataclass
from fnmatch import fnmatchcase
from pathlib import Path

import numpy as np

from silpose.core.errors import InputError
from silpose.silhouette.masks.array_files import ARRAYS
from silpose.silhouette.masks.image_files import IMAGES
from silpose.silhouette.masks.video_files import VIDEOS
from silpose.silhouette.masks.yolo import LABELS, yolo_files

_GLOB = re.compile(r"[*?\[]")
_MANY = (*VIDEOS, *ARRAYS)  # suffixes of files that hold many masks


@dataclass(frozen=True)
class MaskTake:
    """One take of a tree.

    Attributes
    ----------
    path : Path
        Folder of images, or a file that holds many masks.
    name : str
        Its path below the tree's root, with ``/`` between folders; a file without its suffix,
        unless another take has that name.
    """

    path: Path
    name: str

    @property
    def changed(self) -> int:
        """When files were added, removed or, of a single file, written: nanoseconds."""
        return self.path.stat().st_mtime_ns


@dataclass(frozen=True)
class TreePattern:
    """Which takes of a tree are wanted, and what the levels of its folders are called.

    Attributes
    ----------
    levels : tuple of str
        From the root down: a plain word is the name of a level, all of whose folders are taken;
        with ``*``, ``?`` or ``[…]`` it says which. Empty if takes may be at any depth.
    """

    levels: tuple[str, ...] = ()

    @classmethod
    def of(cls, text: str | None) -> TreePattern:
        """Read a pattern such as ``subject/nm-*/view``; None takes all."""
        if text is None:
            return cls()
        levels = tuple(text.split("/"))
        if not all(levels):
            raise InputError(
                f"pattern '{text}' has an empty level: name each, as in subject/sequence/view"
            )
        names = [level for level in levels if not _GLOB.search(level)]
        if len({*names}) < len(names):
            raise InputError(f"pattern '{text}' names two levels alike: give each its own name")
        return cls(levels)

    @property
    def columns(self) -> list[str]:
        """Names of the levels; those with a ``*`` are called by their number, as ``level2``."""
        return [
            f"level{k}" if _GLOB.search(level) else level
            for k, level in enumerate(self.levels, start=1)
        ]

    def fits(self, name: str) -> bool:
        """Whether a take is wanted."""
        if not self.levels:
            return True
        parts = name.split("/")
        return len(parts) == len(self.levels) and all(
            not _GLOB.search(level) or fnmatchcase(part, level)
            for part, level in zip(parts, self.levels, strict=True)
        )

    def parts(self, name: str) -> list[str]:
        """Name of a take's folder on each level that `columns` names."""
        return name.split("/") if self.levels else []


def is_tree(root: str | Path) -> bool:
    """Whether a path is a folder that holds no masks itself, but takes below it."""
    root = Path(root)
    if not root.is_dir() or _with_images([file.name for file in root.iterdir() if file.is_file()]):
        return False
    if yolo_files(root / LABELS):  # beside which are pictures
        return False
    takes = find_takes(root)
    first = next(takes, None)
    if first is None or first.path == root:
        return False
    # A single file in the folder itself is that folder's masks.
    return first.path.is_dir() or first.path.parent != root or next(takes, None) is not None


def find_takes(root: str | Path, pattern: TreePattern | None = None) -> Iterator[MaskTake]:
    """Find the takes of a tree, folder by folder in alphabetical order.

    Hidden files and folders are passed over.

    Parameters
    ----------
    root : path
    pattern : TreePattern, optional
        By default all takes, at any depth.

    Yields
    ------
    take : MaskTake
    """
    root, pattern = Path(root), pattern or TreePattern()
    known: set[str] = set()
    for folder, below, files in os.walk(root, followlinks=True):
        here = Path(folder)
        if (real := os.path.realpath(folder)) in known:  # a link to a folder above it
            below[:] = []
            continue
        known.add(real)
        below[:] = sorted(name for name in below if not name.startswith((".", "__MACOSX")))
        yield from (t for t in _takes_in(here, root, sorted(files)) if pattern.fits(t.name))


def _takes_in(folder: Path, root: Path, files: list[str]) -> Iterator[MaskTake]:
    name = folder.relative_to(root).as_posix()
    if _with_images(files):
        yield MaskTake(folder, name)
        return
    many = [f for f in files if not f.startswith(".") and f.lower().endswith(_MANY)]
    if len(many) > 1 and _is_one_mask(folder / many[0]):
        yield MaskTake(folder, name)
        return
    stems = [f.rpartition(".")[0] for f in many]
    for file, stem in zip(many, stems, strict=True):
        own = stem if stems.count(stem) == 1 else file
        yield MaskTake(folder / file, own if name == "." else f"{name}/{own}")


def _with_images(files: list[str]) -> bool:
    """Whether a folder with these files holds images; to read their names is enough, and fast."""
    return any(f.lower().endswith(tuple(IMAGES)) and not f.startswith(".") for f in files)


def _is_one_mask(file: Path) -> bool:
    """Whether a file holds an array of a single mask."""
    if file.suffix.lower() != ".npy":
        return False
    try:
        return np.load(file, mmap_mode="r", allow_pickle=False).ndim == 2
    except (OSError, ValueError):
        return False

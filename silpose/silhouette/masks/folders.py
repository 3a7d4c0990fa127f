"""Which files of a folder are one take of masks, and in which order."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from silpose.core.errors import InputError
from silpose.silhouette.masks.image_files import IMAGES
from silpose.silhouette.masks.natural_order import (
    in_natural_order,
    kinds_of_names,
    takes_among,
    without_numbers,
)

_SYSTEM = ("thumbs.db", "desktop.ini", "__macosx")
_MOST_KINDS = 6  # of names; more are names without any order
_FEW = 0.2  # share of the files that may be left out beside others
_EXACT = (".png", ".bmp", ".tif", ".tiff", ".webp")  # of copies, those that keep values
_LISTED = 5


@dataclass(frozen=True)
class Chosen:
    """Files of one take, in order.

    Attributes
    ----------
    files : list of Path
    ignored : tuple of str
        Files that were left out, each with the reason.
    doubts : tuple of str
        What the user should be told of these.
    """

    files: list[Path]
    ignored: tuple[str, ...] = ()
    doubts: tuple[str, ...] = ()


def image_files(folder: str | Path) -> list[Path]:
    """List a folder's images in the order of the numbers in their names (2 before 10).

    Hidden files and what systems leave behind are passed over, as are folders and dangling links
    with an image's name.

    Returns
    -------
    files : list of Path
        Empty if there are none.
    """
    return _in_order(_images(Path(folder)).files)


def choose_files(folder: Path, is_masks: Callable[[Sequence[Path]], bool]) -> Chosen:
    """Choose the images of a folder that are one take of masks.

    Parameters
    ----------
    folder : Path
    is_masks : callable
        Whether some files look like masks; it is asked only where files are of several kinds.

    Raises
    ------
    InputError
        If there are no images, or several takes.
    """
    found = _images(folder)
    groups = _groups(found.files)
    kinds = _by_suffix(found.files)
    if len(groups) < 2 <= len(kinds) and not is_masks(found.files):
        groups = kinds  # photos and masks, whose names tell them apart by nothing else
    if len(groups) < 2:
        files = _in_order(found.files)
        return Chosen(files, found.ignored, (*_takes(folder, files), *_no_order(folder, files)))
    masks = {name: files for name, files in groups.items() if is_masks(files)}
    if not masks:  # what they are, is said when they are read
        return Chosen(_in_order(max(groups.values(), key=len)), found.ignored)
    taken = max(masks.values(), key=lambda files: (len(files), _preferred(files[0])))
    left: list[tuple[list[Path], str]] = []
    several = {}
    for name, files in groups.items():
        if files is taken:
            continue
        if name not in masks:
            left.append((files, "look like no masks"))
        elif {file.stem for file in files} <= {file.stem for file in taken}:
            left.append((files, "have the same names"))
        else:
            several[name] = files
            left.append((files, "are named unlike the others"))
    if sum(map(len, several.values())) > _FEW * len(taken):
        raise InputError(_several_takes(folder, [taken, *several.values()]))
    ignored = [f"{file.name}: {why}" for files, why in left for file in _in_order(files)]
    doubts = [_left_out(folder, files, taken, why) for files, why in left]
    files = _in_order(taken)
    return Chosen(files, (*found.ignored, *ignored), (*doubts, *_takes(folder, files)))


def _images(folder: Path) -> Chosen:
    """List a folder's images, and say what else of that name there is."""
    if not folder.is_dir():
        raise InputError(f"there is no folder '{folder}': give one that holds mask images")
    files, ignored = [], []
    for file in sorted(folder.iterdir()):
        if file.name.startswith(".") or file.name.lower() in _SYSTEM:
            continue
        if file.suffix.lower() not in IMAGES:
            if file.is_file():
                ignored.append(f"{file.name}: no image")
        elif file.is_file():
            files.append(file)
        else:
            kind = "a folder" if file.is_dir() else "a link to nothing"
            ignored.append(f"{file.name}: {kind}")
    return Chosen(files, tuple(ignored))


def _groups(files: Sequence[Path]) -> dict[str, list[Path]]:
    """Group files by what their names have in common beside numbers, and copies by suffix."""
    groups: dict[str, list[Path]] = {}
    for name, file in zip(kinds_of_names([file.stem for file in files]), files, strict=True):
        groups.setdefault(name, []).append(file)
    if len(groups) > _MOST_KINDS or not any("#" in name for name in groups):
        groups = {"": list(files)}  # names of letters and digits at random, or without numbers
    apart: dict[str, list[Path]] = {}
    for name, group in groups.items():
        copied = len({file.stem for file in group}) < len(group)
        for file in group:
            suffix = file.suffix.lower() if copied else ""
            apart.setdefault(name + suffix, []).append(file)
    return apart


def _by_suffix(files: Sequence[Path]) -> dict[str, list[Path]]:
    groups: dict[str, list[Path]] = {}
    for file in files:
        groups.setdefault(file.suffix.lower(), []).append(file)
    return groups


def _preferred(file: Path) -> bool:
    return file.suffix.lower() in _EXACT


def _in_order(files: Sequence[Path]) -> list[Path]:
    return [files[k] for k in in_natural_order([file.stem for file in files])]


def _left_out(folder: Path, files: Sequence[Path], taken: Sequence[Path], why: str) -> str:
    names = ", ".join(f"'{file.name}'" for file in _in_order(files)[:_LISTED])
    more = f" and {len(files) - _LISTED} more" if len(files) > _LISTED else ""
    first = _in_order(taken)[0].name
    return (
        f"of '{folder}', {len(taken)} files such as '{first}' were taken and {len(files)} left "
        f"out that {why}: {names}{more}"
    )


def _takes(folder: Path, files: Sequence[Path]) -> tuple[str, ...]:
    """Doubt that files are one take, where they count anew."""
    starts = takes_among([file.stem for file in files])
    if not starts:
        return ()
    first, second = files[0], files[starts[1]]
    count = len(starts)
    head = re.sub(r"\d+\D*$", "", first.stem)
    return (
        f"'{folder}' seems to hold {count} takes, which begin with '{first.name}', '{second.name}'"
        f"{' and so on' if count > 2 else ''}, and is read as one: choose one by a pattern in "
        f"quotes, such as '{folder / head}*{first.suffix}'",
    )


def _no_order(folder: Path, files: Sequence[Path]) -> tuple[str, ...]:
    """Doubt the order of files whose names have little in common beside numbers."""
    if len(set(kinds_of_names([file.stem for file in files]))) <= _MOST_KINDS:
        return ()
    return (
        f"the names in '{folder}' tell no order in time: they are read from '{files[0].name}' to "
        f"'{files[-1].name}'; if they are one take, number them by time",
    )


def _several_takes(folder: Path, takes: Sequence[Sequence[Path]]) -> str:
    examples = [_in_order(files)[0] for files in takes]
    listed = ", ".join(f"{len(f)} like '{e.name}'" for f, e in zip(takes, examples, strict=True))
    pattern = without_numbers(examples[0].stem).replace("#", "*") + examples[0].suffix
    return (
        f"'{folder}' holds several kinds of masks, {listed}: choose one by a pattern in quotes, "
        f"such as '{folder / pattern}'"
    )

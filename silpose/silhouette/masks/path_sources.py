"""Pictures behind a path: of a file, a folder, or a pattern of names."""

from __future__ import annotations

import glob
import os
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path

from silpose.core.errors import InputError
from silpose.core.home_folder import expanded
from silpose.silhouette.masks.array_files import ARRAYS, read_array_file
from silpose.silhouette.masks.arrays import pictures_of_array
from silpose.silhouette.masks.coco import read_coco, read_labelme
from silpose.silhouette.masks.decision import decide
from silpose.silhouette.masks.encoding import NoMasksError
from silpose.silhouette.masks.folders import choose_files, image_files
from silpose.silhouette.masks.image_files import IMAGES, Animation, read_image_file
from silpose.silhouette.masks.mask_source import MaskSource
from silpose.silhouette.masks.mots import is_mots, read_mots
from silpose.silhouette.masks.natural_order import in_natural_order
from silpose.silhouette.masks.other_formats import why_no_masks, why_not_read
from silpose.silhouette.masks.picture import Picture
from silpose.silhouette.masks.video_files import VIDEOS, read_video
from silpose.silhouette.masks.yolo import LABELS, is_yolo, labels_of, read_yolo, yolo_files

_SAMPLE = 5  # files of a kind that are looked at


@dataclass(frozen=True)
class Found:
    """What a source holds, before its encoding is decided; else as of `MaskSequence`."""

    animation: Animation
    source: str
    ignored: tuple[str, ...] = ()
    doubts: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()


def find_pictures(source: str | os.PathLike[str], options: MaskSource) -> Found:
    """Read the pictures behind a path, of whatever kind.

    Parameters
    ----------
    source : path
    options : MaskSource
        Used where files of a folder have to be told apart.

    Raises
    ------
    InputError
        If nothing can be read there; it says what to do.
    """
    if not os.fspath(source):  # which would be the current folder, like "."
        raise InputError("the path of the masks is empty: give that of a folder or file")
    path = Path(source)
    try:
        path.exists()
    except (OSError, ValueError) as error:  # too long, or with a null character
        raise InputError(f"{str(path)!r} cannot be a path: {error}") from None
    try:
        return _find_path(path, options)
    except OSError as error:
        raise InputError(f"'{path}' cannot be read: {error.strerror or error}") from None


def _find_path(path: Path, options: MaskSource) -> Found:
    name = f"'{path}'"
    if path.parts and path.parts[0].startswith("~") and not path.exists():
        path = expanded(path)
    if path.is_dir():
        return _find_folder(path, options)
    if not path.exists():
        return _find_pattern(path)
    suffix = path.suffix.lower()
    if suffix in VIDEOS:
        return Found(read_video(path), name)
    if suffix in ARRAYS:
        return Found(Animation(pictures_of_array(read_array_file(path), name)), name)
    if suffix == ".json":
        pictures, doubts = read_coco(path)
        return Found(Animation(pictures), name, doubts=doubts)
    if suffix == ".txt" and is_mots(path):
        return Found(Animation(read_mots(path)), name)
    if suffix == ".txt" and is_yolo(path):
        return Found(Animation(read_yolo([path])), name)
    if why := why_not_read(path):
        raise InputError(f"{name} {why}")
    if suffix in IMAGES:
        return Found(read_image_file(path), name)
    return Found(_of_unknown_suffix(path), name)


def _of_unknown_suffix(path: Path) -> Animation:
    try:
        return read_image_file(path)
    except InputError:
        return read_video(path)


def _find_folder(folder: Path, options: MaskSource) -> Found:
    chosen = choose_files(folder, lambda files: _are_masks(files, options))
    name, texts = f"'{folder}'", yolo_files(folder)
    if texts and not (chosen.files and _are_masks(chosen.files, options)):
        ignored = tuple(f"{file.name}: the picture of a text" for file in chosen.files)
        return Found(Animation(read_yolo(texts)), name, ignored)
    for labels in (folder / LABELS, labels_of(folder)):
        if labels is None or not (texts := yolo_files(labels)):
            continue
        if not (chosen.files and _are_masks(chosen.files, options)):
            note = f"the masks are in '{labels}'"
            return Found(Animation(read_yolo(texts)), name, notes=(note,))
    annotations = [file for file in folder.glob("*.json") if not file.name.startswith(".")]
    if len(annotations) == 1 and chosen.files and not _are_masks(chosen.files, options):
        note = f"the masks are in '{annotations[0]}'"
        with suppress(InputError):  # it may be something else
            return replace(_find_path(annotations[0], options), notes=(note,))
    if chosen.files:
        return Found(_read_all(chosen.files), name, chosen.ignored, chosen.doubts)
    alone = [
        file
        for file in folder.iterdir()
        if file.suffix.lower() in (*VIDEOS, *ARRAYS, ".json") and not file.name.startswith(".")
    ]
    inside = [] if alone else _folders_of_images(folder)
    if len(alone) + len(inside) == 1:
        (only,) = alone + inside
        return replace(_find_path(only, options), notes=(f"the masks are in '{only}'",))
    if alone:
        return _find_frames(folder, alone)
    if inside:
        raise InputError(
            f"folder '{folder}' holds no masks itself, but folders of them, such as '{inside[0]}' "
            f"and '{inside[1]}': give one"
        )
    if why := why_no_masks(folder):
        raise InputError(f"folder '{folder}' holds no masks; {why}")
    raise InputError(
        f"folder '{folder}' holds no masks: expected {', '.join(IMAGES[:7])} files, or a video"
    )


def _find_frames(folder: Path, files: list[Path]) -> Found:
    """Read a folder of arrays or JSON, each of which is one mask."""
    arrays = [file.suffix.lower() in ARRAYS for file in files]
    json = [file.suffix.lower() == ".json" for file in files]
    if not all(arrays) and not all(json):
        listed = ", ".join(f"'{file.name}'" for file in sorted(files)[:3])
        raise InputError(f"folder '{folder}' holds {len(files)} takes, {listed}: give one")
    pictures: list[Picture] = []
    doubts: list[str] = []
    files = [files[k] for k in in_natural_order([file.stem for file in files])]
    if all(json) and (labelme := read_labelme(files, f"'{folder}'")) is not None:
        return Found(Animation(labelme[0]), f"'{folder}'", doubts=labelme[1])
    for file in files:
        if all(arrays):
            held = pictures_of_array(read_array_file(file), f"'{file}'")
        else:
            held, own = read_coco(file)
            doubts += own
        if len(held) > 1:
            raise InputError(
                f"folder '{folder}' holds {len(files)} takes, '{file.name}' of {len(held)} "
                "masks: give one"
            )
        pictures += [replace(picture, name=file.name) for picture in held]
    return Found(Animation(pictures), f"'{folder}'", doubts=tuple(doubts[:1]))


def _folders_of_images(folder: Path) -> list[Path]:
    """Find the first two folders below one that hold images."""
    found: list[Path] = []
    for root, folders, _ in os.walk(folder):
        folders[:] = sorted(name for name in folders if not name.startswith((".", "__MACOSX")))
        if Path(root) != folder and image_files(root):
            found.append(Path(root))
        if len(found) == 2:
            break
    return found


def _find_pattern(path: Path) -> Found:
    files = [Path(found) for found in glob.glob(str(path)) if Path(found).is_file()]
    if not files:
        raise InputError(f"there is no file or folder '{path}': give an existing path of masks")
    files = [files[k] for k in in_natural_order([file.stem for file in files])]
    return Found(_read_all(files), f"'{path}'")


def _read_all(files: Sequence[Path]) -> Animation:
    """Read image files; one alone may have a rate."""
    read = [read_image_file(file) for file in files]
    pictures = [picture for animation in read for picture in animation.pictures]
    return Animation(pictures, read[0].frames_per_second if len(read) == 1 else None)


def _are_masks(files: Sequence[Path], options: MaskSource) -> bool:
    """Whether a few of some files can be read as masks, not as cut-outs, which may lie beside."""
    sample = files[:: max(1, len(files) // _SAMPLE)]
    try:
        return not decide(_read_all(sample).pictures, options, "").plane.cut_out
    except NoMasksError:
        return False
    except InputError:  # which is told when they are read
        return True

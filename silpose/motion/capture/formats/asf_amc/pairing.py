"""The ASF that belongs to an AMC, found by its name."""

from __future__ import annotations

from pathlib import Path

from silpose.core.errors import InputError


def find_skeleton(file: Path) -> tuple[Path, tuple[str, ...]]:
    """Find the skeleton of an AMC file.

    It is searched in the file's folder, the folder above, and that one's other folders. The name of
    an ASF is the beginning of its AMCs' names (``02.asf`` of ``02_01.amc``); the only ASF of the
    AMC's own folder, or the only one of the folder above, may have any name.

    Parameters
    ----------
    file : Path
        The AMC.

    Returns
    -------
    asf : Path
    notes : tuple of str
        Says so if the names do not agree.

    Raises
    ------
    InputError
        If there is none, or it is not sure which of several.
    """
    folder = file.absolute().parent
    near = _skeletons(folder)
    above = _skeletons(folder.parent)
    around = [
        asf for other in _folders(folder.parent) if other != folder for asf in _skeletons(other)
    ]
    for place in (near, above, around):
        if (asf := _by_name(file.stem, place)) is not None:
            return asf, ()
    for place in (near, above):
        if len(place) == 1:
            note = f"its skeleton is taken from {place[0].name}, the only ASF there"
            return place[0], (note,)
    found = ", ".join(asf.name for asf in near[:5]) or "none"
    raise InputError(
        f"{file}: its skeleton is not sure: beside it there are the ASF files: {found}; put the "
        "right one beside it, named as the AMC begins, such as 02.asf for 02_01.amc"
    )


def _by_name(stem: str, candidates: list[Path]) -> Path | None:
    """Find the ASF with the longest name that is the AMC's or its beginning."""
    stem = stem.lower()
    fits = [
        asf
        for asf in candidates
        if stem.startswith(name := asf.stem.lower()) and not stem[len(name) :][:1].isalnum()
    ]
    return max(fits, key=lambda asf: len(asf.stem), default=None)


def _skeletons(folder: Path) -> list[Path]:
    try:
        return sorted(
            path
            for path in folder.iterdir()
            if path.suffix.lower() == ".asf" and not path.name.startswith(".")
        )
    except OSError:
        return []


def _folders(folder: Path) -> list[Path]:
    try:
        return sorted(path for path in folder.iterdir() if path.is_dir())[:1000]
    except OSError:
        return []

"""Files that hold masks in a form that is not read, and what to do with each."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import islice
from pathlib import Path

_SAVE = "save the masks by np.save('masks.npy', masks)"

_ADVICE: Mapping[tuple[str, ...], str] = {
    (".pkl", ".pickle", ".pt", ".pth"): (
        f"holds pickled objects, which could run any program: load it where it is from, and {_SAVE}"
    ),
    (".zip", ".tar", ".gz", ".tgz", ".bz2", ".xz", ".7z", ".rar"): (
        "is an archive: unpack it, and give what is in it"
    ),
    (".mat",): (
        "is of MATLAB: read it by scipy.io.loadmat (by h5py, if it was saved with -v7.3), and "
        f"{_SAVE}, frames first"
    ),
    (".h5", ".hdf5", ".hdf"): f"is of HDF5: read it by h5py, and {_SAVE}, frames first",
    (".parquet", ".feather", ".arrow"): f"is a table: read it by pandas, and {_SAVE}, frames first",
    (".heic", ".heif", ".exr", ".psd", ".svg", ".dcm", ".nrrd", ".nii"): (
        "is an image of a kind that is not read: save it as PNG"
    ),
    (".xml",): "is XML, as of CVAT: export the annotations as COCO (JSON), or as mask images",
    (".txt", ".csv"): (
        "is text, which is read in the forms of MOTS and YOLO only: draw its masks as images, or "
        "export them as COCO (JSON)"
    ),
}
_LOOKED_AT = 2000  # files of a folder


def why_not_read(file: Path) -> str | None:
    """Say why a file is not read and what to do, to follow its name; None of all other files."""
    suffix = file.suffix.lower()
    return next((why for suffixes, why in _ADVICE.items() if suffix in suffixes), None)


def why_no_masks(folder: Path) -> str | None:
    """Say which files in or below a folder are not read and why; None if there are none."""
    found: dict[str, list[Path]] = {}
    for file in islice(folder.rglob("*"), _LOOKED_AT):
        if (why := why_not_read(file)) and not file.name.startswith("."):
            found.setdefault(why, []).append(file)
    if not found:
        return None
    why, files = max(found.items(), key=lambda own: len(own[1]))
    return f"'{min(files)}' {why}"

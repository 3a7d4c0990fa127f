"""The folder ``conf/``: its groups, and the files to choose from in each."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from silpose.core.errors import InputError


@cache
def config_folder() -> Path:
    """Find ``conf/``: inside an installed package, or beside it in a checkout."""
    here = Path(__file__).resolve().parents[1]
    for folder in (here / "conf", here.parent / "conf"):
        if (folder / "config.yaml").is_file():
            return folder
    raise InputError(f"the settings folder 'conf' is missing beside '{here}': install silpose anew")


@cache
def groups() -> dict[str, tuple[str, ...]]:
    """List the choices of every group, such as ``silhouette/scenes``, by its name."""
    root = config_folder()
    files = sorted(root.glob("*/**/*.yaml"))
    folders = sorted({file.parent for file in files})
    return {
        folder.relative_to(root).as_posix(): tuple(f.stem for f in files if f.parent == folder)
        for folder in folders
    }

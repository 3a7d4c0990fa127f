"""Where the settings and tables in ``conf/`` are."""

from __future__ import annotations

from pathlib import Path

from silpose.errors import InputError


def config_folder() -> Path:
    """Find ``conf/``: inside an installed package, or beside it in a checkout."""
    here = Path(__file__).resolve().parent
    for folder in (here / "conf", here.parent / "conf"):
        if (folder / "config.yaml").is_file():
            return folder
    raise InputError(f"the settings folder 'conf' is missing beside '{here}': install silpose anew")

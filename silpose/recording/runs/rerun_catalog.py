"""A Rerun catalog of recordings: each a row of properties, all of them one dataset."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from silpose.core.errors import InputError
from silpose.recording.viewer.process import HOST


@contextmanager
def catalog(folder: str | Path, port: int = 0) -> Iterator[str]:
    """Serve the recordings below a folder as a catalog, to this machine only.

    A viewer that opens the address lists them with all their properties: settings, metrics,
    versions. `rerun.catalog.CatalogClient` reads it as a table.

    Parameters
    ----------
    folder : path
        Of a sweep, of an experiment, or of all recordings.
    port : int, default=0
        0 takes any that is free.

    Yields
    ------
    address : str
        The dataset has the folder's name.

    Raises
    ------
    InputError
        If there is no recording, or the port is in use.
    """
    files = sorted(str(file) for file in Path(folder).rglob("run.rrd"))
    if not files:
        raise InputError(f"there is no recording below '{folder}': give the folder of a sweep")
    os.environ.setdefault("RUST_LOG", "error")
    from rerun.server import Server  # loads Rerun

    name = Path(folder).absolute().name
    try:
        server = Server(host=HOST, port=port or None, datasets={name: files})
    except (ValueError, RuntimeError, OSError) as error:
        raise InputError(
            f"cannot serve a catalog ({str(error).splitlines()[0]}): "
            "choose another --port, or repair recordings that were cut off"
        ) from error
    try:
        yield server.url()
    finally:
        server.shutdown()

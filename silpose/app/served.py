"""Verbs that serve the runs below a folder: as a page, or as a catalog."""

from __future__ import annotations

import argparse
from pathlib import Path

RECORDINGS = Path("recordings")
"""Where runs are if nothing else is said; it need not be there yet."""


def root_option(verb: argparse.ArgumentParser) -> None:
    """Add the folder of runs, which need not be given."""
    of_runs = "of runs, 'recordings' by default"
    verb.add_argument(
        "folder", nargs="?", type=Path, default=RECORDINGS, metavar="FOLDER", help=of_runs
    )


def serve_options(verb: argparse.ArgumentParser) -> None:
    """Add the options of ``silpose serve``."""
    root_option(verb)
    verb.add_argument("--port", type=int, default=9090)


def serve(given: argparse.Namespace) -> None:
    """Serve the runs below a folder as a page, until Ctrl-C."""
    from silpose.experiments.catalogue import CATALOGUE
    from silpose.recording import serve as serve_page

    serve_page(
        given.folder, given.port, {name: entry.question for name, entry in CATALOGUE.items()}
    )


def catalog_options(verb: argparse.ArgumentParser) -> None:
    """Add the options of ``silpose catalog``."""
    root_option(verb)
    verb.add_argument("--port", type=int, default=0, help="any free one by default")


def catalog(given: argparse.Namespace) -> None:
    """Serve the recordings below a folder as a Rerun catalog, until Ctrl-C."""
    from silpose.app.paths import rerun_command
    from silpose.recording import catalog as serve_catalog
    from silpose.recording.viewer.process import until_interrupted

    with serve_catalog(given.folder, given.port) as address:
        print(f"Open it:  {rerun_command()} {address}   (until Ctrl-C)", flush=True)
        until_interrupted()

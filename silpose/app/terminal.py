"""The standard output as tables and styled words are printed to it."""

from __future__ import annotations

from rich.console import Console


class Terminal(Console):
    """The standard output; one that nobody reads any more ends the command without an error."""

    def on_broken_pipe(self) -> None:
        """Leave it to `silpose.app.main`, which ends quietly; by default the exit status is 1."""
        raise BrokenPipeError

"""Where the command prints: a terminal of any kind, a file, a pipe, a full disk, or nowhere."""

from __future__ import annotations

import os
import sys
from contextlib import suppress
from typing import Any, TextIO, cast

from silpose.core.errors import InputError


def print_anywhere() -> None:
    """Print wherever the outputs go, and nowhere where the shell has closed them.

    Signs that a terminal cannot show become question marks. What cannot be written to the standard
    output is one sentence. What is said on the way, on the error output, is lost rather than the
    run.
    """
    for number, name in enumerate(("stdin", "stdout", "stderr")):
        _fill(number)
        if getattr(sys, name) is None:
            setattr(sys, name, os.fdopen(number, "w" if number else "r", encoding="utf-8"))
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="replace")
    sys.stdout = cast(TextIO, _Output(sys.stdout))
    sys.stderr = cast(TextIO, _ErrorOutput(sys.stderr))


def stop_quietly() -> None:
    """End output that nobody reads any more, as when it goes to ``head``."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _fill(number: int) -> None:
    """Keep files from getting the number of a closed stream, to which other programs print."""
    try:
        os.fstat(number)
    except OSError:
        null = os.open(os.devnull, os.O_RDWR)
        if null != number:
            os.dup2(null, number)
            os.close(null)


class _Output:
    """The standard output, with a sentence where it cannot be written."""

    def __init__(self, stream: TextIO) -> None:
        self._stream, self._failed = stream, False

    def write(self, text: str) -> int:
        self._try(self._stream.write, text)
        return len(text)

    def flush(self) -> None:
        self._try(self._stream.flush)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)

    def _try(self, do: Any, *given: str) -> None:
        if self._failed:
            return  # said once; Python flushes again when it ends
        try:
            do(*given)
        except BrokenPipeError:
            raise
        except OSError as error:
            self._failed = True
            raise InputError(
                f"the standard output cannot be written ({error.strerror or error}): free some "
                "space there, or send it elsewhere"
            ) from error


class _ErrorOutput(_Output):
    """The error output; there is no place to say that it cannot be written."""

    def _try(self, do: Any, *given: str) -> None:
        with suppress(OSError):
            do(*given)

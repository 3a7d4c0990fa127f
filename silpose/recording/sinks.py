"""Where a recording goes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from silpose.core.errors import InputError

KINDS = ("file", "viewer", "web")


@dataclass(frozen=True)
class Sinks:
    """Where a recording goes, possibly to several places at once.

    Attributes
    ----------
    kinds : sequence of str
        Any of ``file``, ``viewer`` (on this machine's screen), ``web`` (in a browser); none for
        no recording.
    viewer_port : int
        Port of the viewer: of one that is open, else of the one to be opened.
    web_port : int
        Port of the page; the port after it brings the data.

    Raises
    ------
    InputError
        If there is no such kind or no such port.
    """

    kinds: Sequence[str]
    viewer_port: int
    web_port: int

    def __post_init__(self) -> None:
        for kind in self.kinds:
            if kind not in KINDS:
                raise InputError(
                    f"recording.sinks must list any of {', '.join(KINDS)}, not '{kind}'"
                )
        for name in ("viewer_port", "web_port"):
            if not 0 < getattr(self, name) < 65535:
                raise InputError(
                    f"recording.{name} must be a port, 1 to 65534, not {getattr(self, name)}"
                )

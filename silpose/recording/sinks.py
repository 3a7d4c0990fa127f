"""Where a recording goes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from silpose.core.errors import InputError

KINDS = ("file", "viewer", "web")


@dataclass(frozen=True)
class Sinks:
    """Where a recording goes, to several places at once if need be.

    Attributes
    ----------
    kinds : sequence of str
        Any of ``file``, ``viewer`` (on this machine's screen), ``web`` (in a browser); none for
        no recording.
    viewer_port : int
        Where the viewer listens, or is made to listen.
    web_port : int
        Of the page; the port after it brings the data.
    """

    kinds: Sequence[str] = ("file",)
    viewer_port: int = 9876
    web_port: int = 9090

    def __post_init__(self) -> None:
        for kind in self.kinds:
            if kind not in KINDS:
                raise InputError(
                    f"recording.sinks is a list of any of {', '.join(KINDS)}, without '{kind}'"
                )
        for name in ("viewer_port", "web_port"):
            if not 0 < getattr(self, name) < 65535:
                raise InputError(
                    f"recording.{name} is a port, 1 to 65534, not {getattr(self, name)}"
                )

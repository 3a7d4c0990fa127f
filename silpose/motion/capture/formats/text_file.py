"""Text of motion capture files, in whatever encoding people have it."""

from __future__ import annotations

import codecs
import re
from pathlib import Path

from silpose.core.errors import InputError

LARGEST = 500_000_000
"""Bytes of the largest text that is read."""

DAMAGED = "it may be truncated or damaged, export or download it again"
"""The remedy for text that is not as its format demands."""

# What files are that only bear the ending, by how they begin.
_OTHERS = (
    (rb"\s*version https://git-lfs", "is a Git LFS pointer; fetch its content with 'git lfs pull'"),
    (rb"\s*<(!doctype|html|\?xml)", "is a web page, its download failed; download it again"),
    (rb"PK\x03\x04", "is a zip archive; unpack it"),
    (rb"\x1f\x8b", "is compressed with gzip; unpack it"),
    (rb"Kaydara FBX|\s*; FBX", "is an FBX file; export it as BVH"),
)


def read_lines(file: Path, kind: str) -> tuple[list[str], bool]:
    """Read a text file's lines.

    Parameters
    ----------
    file : Path
        UTF-8, UTF-16 or Latin-1, with the ends of lines of any system.
    kind : str
        Named in errors: "BVH file".

    Returns
    -------
    lines : list of str
    complete : bool
        Whether the last line has an end, so that its last number is surely whole.

    Raises
    ------
    InputError
        If the file cannot be read or is evidently something else.
    """
    try:
        size = file.stat().st_size
        if size > LARGEST:
            raise InputError(
                f"{file}: has {size / 1e6:.0f} MB, more than {LARGEST / 1e6:.0f}; split it into "
                "shorter takes"
            )
        content = file.read_bytes()
    except OSError as error:
        raise InputError(f"{file}: cannot be read ({error.strerror or error})") from error
    for beginning, what in _OTHERS:
        if re.match(beginning, content[:200], re.IGNORECASE):
            raise InputError(f"{file}: is no {kind} but {what.removeprefix('is ')}")
    text = _decoded(content).rstrip("\x00\x1a")
    text = text.replace("\r\n", "\n").replace("\r", "\n")
    return text.split("\n"), text.endswith("\n")


def number(word: str) -> float:
    """Convert a word, or give NaN; an underscore, which Python allows, is no part of a number."""
    try:
        return float("nan" if "_" in word else word)
    except ValueError:
        return float("nan")


def shown(word: str) -> str:
    """Quote a word of a file for a message: short and printable."""
    short = word if len(word) <= 30 else f"{word[:30]}…"
    return "'" + "".join(c if c.isprintable() else "?" for c in short) + "'"


def _decoded(content: bytes) -> str:
    for mark, encoding in (
        (codecs.BOM_UTF8, "utf-8-sig"),
        (codecs.BOM_UTF16_LE, "utf-16"),
        (codecs.BOM_UTF16_BE, "utf-16"),
    ):
        if content.startswith(mark):
            return content.decode(encoding, errors="replace")
    start = content[:200]
    if len(start) > 1 and start.count(0) > len(start) // 3:  # UTF-16 without its mark
        even = start[::2].count(0)
        return content.decode("utf-16-be" if even > len(start) // 6 else "utf-16-le", "replace")
    try:
        return content.decode("utf-8")
    except UnicodeDecodeError:
        return content.decode("latin-1")

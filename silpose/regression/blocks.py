"""Blocks of examples: where they come from, and how they are read.

A block is a pair of arrays, or a function that returns one wherever it is called: in this process
or in a worker. `stored_blocks` calls such functions once and keeps what they return in files, from
which every later pass reads.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np

from silpose.core.atomic_files import writing
from silpose.core.errors import InputError
from silpose.core.parallel import parallel_map
from silpose.core.types import Array, Indices

Block = tuple[Array, Array] | Callable[[], tuple[Array, Array]]
"""Inputs (n, d) and outputs (n, m), or a function without arguments that returns them."""

Blocks = Sequence[Block]

_NOTE = "blocks.txt"

ROWS = 4096
"""Rows of a block: enough for linear algebra, few enough for memory."""


@dataclass(frozen=True)
class FileBlock:
    """Some rows of two ``.npy`` files, of which no other rows are read.

    Attributes
    ----------
    inputs, outputs : Path
        Files of tables with as many rows.
    start, stop : int or None
        Rows; all by default.
    """

    inputs: Path
    outputs: Path
    start: int | None = None
    stop: int | None = None

    def __call__(self) -> tuple[Array, Array]:
        """Read the rows."""
        rows = slice(self.start, self.stop)
        files = (self.inputs, self.outputs)
        z, x = (np.load(file, mmap_mode="r", allow_pickle=False)[rows] for file in files)
        return np.array(z, dtype=float), np.array(x, dtype=float)


def split_rows(z: Array, x: Array, rows: int = ROWS) -> list[tuple[Array, Array]]:
    """Divide arrays (n, d) and (n, m) into blocks of so many rows."""
    return [(z[i : i + rows], x[i : i + rows]) for i in range(0, len(z), rows)]


def file_blocks(inputs: str | Path, outputs: str | Path, rows: int = ROWS) -> list[FileBlock]:
    """Divide two ``.npy`` files into blocks of so many rows; workers must see the same files."""
    own, others = Path(inputs).resolve(), Path(outputs).resolve()
    count = len(np.load(own, mmap_mode="r", allow_pickle=False))
    return [FileBlock(own, others, i, min(i + rows, count)) for i in range(0, count, rows)]


def stored_blocks(blocks: Blocks, folder: str | Path, made_of: str) -> list[FileBlock]:
    """Make blocks, on the workers of `silpose.core.parallel`, and keep them in files.

    Parameters
    ----------
    blocks : sequence
        For instance functions that render a take and describe its masks.
    folder : path
        Which all workers see. What is there from an earlier call that was stopped is not made
        again.
    made_of : str
        What the blocks depend on, such as the names of takes and all settings. The folder keeps it,
        and is used again for the same only.

    Returns
    -------
    stored : list of FileBlock

    Raises
    ------
    InputError
        If a block cannot be used, the folder not be written to, or it holds other blocks.
    """
    folder = Path(folder).resolve()
    note = folder / _NOTE
    try:
        folder.mkdir(parents=True, exist_ok=True)
        if not note.is_file() and any(folder.iterdir()):
            raise InputError(f"'{folder}' holds other files: choose a folder of its own for blocks")
        if not note.is_file():
            with writing(note) as temporary:
                temporary.write_text(made_of, encoding="utf-8")
        if note.read_text(encoding="utf-8") != made_of:
            raise InputError(f"'{folder}' holds blocks of other data: choose another folder")
    except OSError as error:
        raise InputError(
            f"cannot make the folder '{folder}' of blocks: {error.strerror}"
        ) from error
    return parallel_map(partial(_store, folder), list(enumerate(blocks)), description="blocks")


def read_block(numbered: tuple[int, Block]) -> tuple[Array, Array]:
    """Read and check a block, given with its index."""
    index, block = numbered
    z, x = (np.asarray(part, dtype=float) for part in (block() if callable(block) else block))
    if z.ndim != 2 or x.ndim != 2 or len(z) != len(x) or not len(z):
        raise InputError(
            f"block {index} holds inputs and outputs of shapes {z.shape} and {x.shape}: "
            "expected two tables with as many rows, one or more"
        )
    if not (np.isfinite(z).all() and np.isfinite(x).all()):
        raise InputError(f"block {index} holds values that are not finite: leave these rows out")
    return z, x


def read_rows(blocks: Blocks, starts: Indices, rows: Indices) -> tuple[Array, Array]:
    """Gather some rows of all blocks, which begin at rows `starts`; `rows` are in order."""
    found = []
    places = np.searchsorted(starts, rows, side="right") - 1
    for index in np.unique(places):
        z, x = read_block((int(index), blocks[index]))
        own = rows[places == index] - starts[index]
        found.append((z[own], x[own]))
    return np.concatenate([z for z, _ in found]), np.concatenate([x for _, x in found])


def _store(folder: Path, numbered: tuple[int, Block]) -> FileBlock:
    index, _ = numbered
    own, others = (folder / f"{index:06d}.{name}.npy" for name in ("z", "x"))
    if not others.is_file():  # written last
        for file, part in zip((own, others), read_block(numbered), strict=True):
            with writing(file) as temporary, temporary.open("wb") as opened:
                np.save(opened, part)
    return FileBlock(own, others)

"""The index of a tree's takes: a line per take, written as soon as the take is finished."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from silpose.core.atomic_files import append_line, writing
from silpose.core.csv_text import csv_text
from silpose.core.errors import InputError
from silpose.model.trees.take_table import COUNTS

INDEX, SETTINGS = "takes.csv", "settings.json"
COLUMNS = ("take", "table", *COUNTS, "source_changed", "doubts", "error")


@dataclass
class TreeIndex:
    """Takes that are finished, or could not be read.

    Attributes
    ----------
    folder : Path
        Holds the index, the settings, and the tables.
    rows : dict of dict
        Values of `COLUMNS` by take.
    """

    folder: Path
    rows: dict[str, dict[str, str]] = field(default_factory=dict)

    @classmethod
    def open(cls, folder: Path, settings: Mapping[str, object]) -> TreeIndex:
        """Make the folder, or go on with what is in it.

        Parameters
        ----------
        folder : Path
        settings : mapping
            Everything that the tables depend on, as plain values.

        Raises
        ------
        InputError
            If nothing can be written there, or the folder holds tables of other settings.
        """
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise InputError(
                f"cannot write to '{folder}' ({error.strerror}): choose another by into=FOLDER"
            ) from error
        index, wanted = cls(folder), json.loads(json.dumps(settings))
        known = folder / SETTINGS
        if known.is_file():
            _check_same(folder, _settings(known), wanted)
            index.rows = _read(folder / INDEX)
        elif any(folder.iterdir()):
            raise InputError(
                f"'{folder}' holds other files: choose an empty or new folder by into=FOLDER"
            )
        else:
            with writing(known) as path:
                path.write_text(json.dumps(wanted, indent=2) + "\n", encoding="utf-8")
        index._rewrite(COLUMNS, index.rows.values())
        return index

    def add(self, row: Mapping[str, object]) -> None:
        """Add a take, and write its line at once."""
        text = {name: str(row.get(name, "")) for name in COLUMNS}
        self.rows[text["take"]] = text
        append_line(self.folder / INDEX, csv_text([[text[name] for name in COLUMNS]]))

    def is_done(self, take: str, changed: int) -> bool:
        """Whether a take's table is finished, and its source has not changed since."""
        row = self.rows.get(take)
        return (
            row is not None
            and not row["error"]
            and row["source_changed"] == str(changed)
            and (self.folder / row["table"]).is_file()
        )

    def finish(self, order: Iterable[tuple[str, list[str]]], levels: list[str]) -> None:
        """Write the index anew, in the tree's order and with a column for each of its levels.

        Parameters
        ----------
        order : iterable of (str, list of str)
            Takes, and the names of their folders on each level.
        levels : list of str
            What the levels are called.
        """
        rows = [
            self.rows[take] | dict(zip(levels, parts, strict=True))
            for take, parts in order
            if take in self.rows
        ]
        self._rewrite([COLUMNS[0], *levels, *COLUMNS[1:]], rows)

    def _rewrite(self, columns: Iterable[str], rows: Iterable[Mapping[str, str]]) -> None:
        names = list(columns)
        with (
            writing(self.folder / INDEX) as path,
            path.open("w", newline="", encoding="utf-8") as file,
        ):
            file.write(csv_text([names, *([row[name] for name in names] for row in rows)]))


def _check_same(folder: Path, known: Mapping[str, object], wanted: Mapping[str, object]) -> None:
    differ = [name for name in {**known, **wanted} if known.get(name) != wanted.get(name)]
    if differ:
        name = differ[0]
        change = "" if name == "model" else f" ({known.get(name)} there, {wanted.get(name)} now)"
        raise InputError(
            f"'{folder}' holds poses of another {name}{change}: choose another folder by "
            "into=FOLDER, or remove it"
        )


def _read(file: Path) -> dict[str, dict[str, str]]:
    """Read an index; lines that are not whole are left out, and their tables looked at again."""
    if not file.is_file():
        return {}
    text = file.read_bytes().decode(errors="replace").replace("\0", "\ufffd")
    whole = text[: text.rfind("\n") + 1]
    try:
        rows = list(csv.DictReader(io.StringIO(whole, newline="")))
    except csv.Error as error:
        raise _damaged(file, error) from None
    return {row["take"]: {name: row[name] for name in COLUMNS} for row in rows if _is_whole(row)}


def _is_whole(row: Mapping[str, str | None]) -> bool:
    values = [row.get(name) for name in COLUMNS]
    counted = row.get("error") or all(str(row.get(name)).isdecimal() for name in COUNTS)
    return None not in values and bool(counted)


def _settings(file: Path) -> dict[str, object]:
    try:
        known = json.loads(file.read_bytes())
        if not isinstance(known, dict):
            raise ValueError("it holds no settings")
    except ValueError as error:
        raise _damaged(file, error) from None
    return known


def _damaged(file: Path, error: Exception) -> InputError:
    words = " ".join(str(error).split())
    return InputError(f"'{file}' is damaged ({words}): choose another folder by into=FOLDER")

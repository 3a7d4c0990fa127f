"""The folder of a run: made when the run starts, filled file by file."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass
from pathlib import Path

from silpose.core.atomic_files import writing
from silpose.core.errors import InputError
from silpose.recording.header import Header
from silpose.recording.runs.claim import claimed
from silpose.recording.sinks import Sinks


@dataclass(frozen=True)
class RunFolder:
    """The folder that one run of an experiment fills.

    Attributes
    ----------
    experiment, name : str
        The folder is ``<root>/<experiment>/<name>``; in a sweep the name is ``<sweep>/<run>``.
    folder : Path
    settings : str
        The run's settings as YAML.
    sinks : Sinks
        Where the run's recording goes.
    keep_pictures : bool or None, default=None
        Whether pictures of people are kept; None where the source decides.
    defaults : str, default=""
        What the settings would be had nobody chosen any, as YAML.
    is_new : bool, default=False
        Whether the folder was made for this run, so that nothing else is in it.
    rows : str, default="method"
        What each row of the results is.
    """

    experiment: str
    name: str
    folder: Path
    settings: str
    sinks: Sinks
    keep_pictures: bool | None = None
    defaults: str = ""
    is_new: bool = False
    rows: str = "method"

    @classmethod
    def start(
        cls,
        experiment: str,
        settings: str = "",
        defaults: str = "",
        rows: str = "method",
        *,
        root: str = "recordings",
        name: str | None = None,
        sweep: str | None = None,
        sinks: Sequence[str] = ("file",),
        viewer_port: int = 9876,
        web_port: int = 9090,
        keep_pictures: bool | None = None,
    ) -> RunFolder:
        """Make the folder of a new run.

        Parameters
        ----------
        experiment : str
        settings : str, default=""
            The run's settings as YAML.
        defaults : str, default=""
            What they would be had nobody chosen any, as YAML.
        rows : str, default="method"
            What each row of the results is.
        root : str, default="recordings"
            Runs go to ``<root>/<experiment>/<name>/``.
        name : str or None, default=None
            Name of the run; None takes the next free number.
        sweep : str or None, default=None
            Name of the sweep that the run is part of; its runs go to
            ``<root>/<experiment>/<sweep>/<name>/``. None names a sweep by what it varies.
        sinks : sequence of str, default=("file",)
            Where the recording goes, any of ``file``, ``viewer``, ``web``; ``[]`` records nothing.
        viewer_port : int, default=9876
            Port of a viewer on this machine's screen; one that is open already is used.
        web_port : int, default=9090
            Port of a page on this machine; the port after it brings the data.
        keep_pictures : bool or None, default=None
            Whether pictures of people are kept in recordings and figures, besides their masks;
            null keeps those of films, and none of cameras.

        Raises
        ------
        InputError
            If the folder cannot be written to, or a parameter has no such value.
        """
        opened = Sinks(sinks, viewer_port, web_port)
        for key, value in (("name", name), ("sweep", sweep)):
            if value is not None and not _names_a_folder(value):
                raise InputError(f"recording.{key} must be the name of one folder, not {value!r}")
        above = Path(root) / experiment
        parent = above / sweep if sweep else above
        try:
            parent.mkdir(parents=True, exist_ok=True)
            is_new = name is None or not (parent / name).exists()
            folder = _new_folder(parent, name)
            probe = folder / ".partial"  # fails now rather than after the work
            probe.touch()
            probe.unlink()
        except OSError as error:
            raise InputError(
                f"cannot write to '{parent}' ({error.strerror}): choose another recording.root"
            ) from error
        own = folder.relative_to(above).as_posix()
        return cls(experiment, own, folder, settings, opened, keep_pictures, defaults, is_new, rows)

    def claimed(self) -> AbstractContextManager[None]:
        """Keep other runs out while the context lasts; an error if one is there."""
        return claimed(self.folder)

    def renew(self) -> None:
        """Make a folder that an earlier run filled an unfinished one, before anything changes."""
        if not self.is_new:
            (self.folder / "metrics.json").unlink(missing_ok=True)
            for cut_off in self.folder.glob(".*partial*"):
                cut_off.unlink()

    def abandon(self, keep: bool = True) -> list[str]:
        """Remove the folder of a run that did not come to its end, if nothing is in it.

        Parameters
        ----------
        keep : bool, default=True
            Whether files that were finished stay. What an earlier run left stays always.

        Returns
        -------
        kept : list of str
            Names of files that are there; none if somebody removed the folder meanwhile.
        """
        if not self.folder.is_dir():
            return []
        if self.is_new and not keep:
            for file in self.folder.iterdir():
                file.unlink()
        kept = sorted(file.name for file in self.folder.iterdir())
        for folder in (self.folder, self.folder.parent):
            if not any(folder.iterdir()):
                folder.rmdir()
        return kept if self.is_new else []

    @contextmanager
    def writing(self, file: str) -> Iterator[Path]:
        """Open a path to write a file to, which gets its name only once it is complete."""
        with writing(self.folder / file) as path:
            yield path

    def header(
        self,
        words: str,
        results: Mapping[str, Mapping[str, float]],
        figure: Path | None = None,
    ) -> Header:
        """Make the header of the run's recording: its words, the results, the run's settings."""
        return Header(
            self.experiment,
            self.name,
            self.folder / "run.rrd",
            words,
            self.settings,
            results,
            self.sinks,
            figure,
            self.defaults,
            self.rows,
        )


def _names_a_folder(name: str) -> bool:
    """Whether a folder can have this name: not another one above, and no control characters."""
    return bool(name) and Path(name).name == name and name != ".." and name.isprintable()


def _new_folder(parent: Path, name: str | None) -> Path:
    """Make the folder of that name, or of the next free number."""
    if name is not None:
        (parent / name).mkdir(exist_ok=True)
        return parent / name
    number = max((int(f.name) for f in parent.iterdir() if f.name.isdigit()), default=0) + 1
    while True:
        folder = parent / f"{number:03d}"
        try:
            folder.mkdir()
        except FileExistsError:  # another process took the number first
            number += 1
        else:
            return folder

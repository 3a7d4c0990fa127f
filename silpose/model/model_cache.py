"""Trained models in the user's cache folder, named by all that training depends on."""

from __future__ import annotations

import tempfile
import warnings
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Self

from platformdirs import user_cache_path

from silpose.core.digest import digest
from silpose.core.errors import InputError
from silpose.core.home_folder import expanded
from silpose.model.loading import load
from silpose.model.model_file import FORMAT
from silpose.model.pose_model import PoseModel

_TRAINING = 2  # one more whenever training makes something else of the same settings


@dataclass(frozen=True)
class ModelCache:
    """One file, that of a model.

    Attributes
    ----------
    file : Path

    See Also
    --------
    ModelCache.of : Names the file.
    """

    file: Path

    @classmethod
    def of(cls, trained_by: str, folder: str | Path | None = None) -> Self:
        """Name the file by what training depends on.

        Parameters
        ----------
        trained_by : str
            Name of all settings of the training.
        folder : path, optional
            By default the user's cache folder, such as ``~/.cache/silpose``, or that of
            ``XDG_CACHE_HOME``.

        Raises
        ------
        InputError
            If that is not known either, as where a program runs as a user without a home.
        """
        place = user_cache_path("silpose", appauthor=False) if folder is None else Path(folder)
        place = expanded(place)
        if place.parts[:1] == ("~",):
            raise InputError(
                "there is no home folder to keep the model in: choose a folder, cache=FOLDER"
            )
        name = digest([version("silpose"), FORMAT, _TRAINING, trained_by])
        return cls(place / f"model_{name}.npz")

    def fetch(self) -> PoseModel | None:
        """Load the model; None if there is none, or with a warning if its file is damaged."""
        if not self.file.is_file():
            return None
        try:
            return load(self.file)
        except InputError:
            warnings.warn(f"'{self.file}' is damaged: the model is trained anew", stacklevel=2)
            return None

    def store(self, model: PoseModel) -> bool:
        """Save the model, complete or not at all, also where several programs do so at once.

        Returns
        -------
        stored : bool
            False, with a warning, where nothing can be written.
        """
        try:
            self.file.parent.mkdir(parents=True, exist_ok=True)
            with tempfile.TemporaryDirectory(dir=self.file.parent) as own:
                model.save(Path(own) / "model.npz")
                (Path(own) / "model.npz").replace(self.file)
        except (OSError, InputError) as error:  # the latter where the disk is full
            cause = error.__cause__ if isinstance(error, InputError) else error
            reason = getattr(cause, "strerror", None) or error
            warnings.warn(
                f"cannot keep the model in '{self.file.parent}' ({reason}), so that it is "
                "trained anew the next time: choose another folder, cache=FOLDER",
                stacklevel=2,
            )
            return False
        return True

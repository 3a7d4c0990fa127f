"""Settings of ``silpose paper``, written ``paper.NAME=value``; others go to every experiment."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, fields
from typing import Any

import yaml

from silpose.app.suggestions import nearest
from silpose.core.errors import InputError


@dataclass(frozen=True)
class PaperOptions:
    """Settings of a run of the whole paper.

    Attributes
    ----------
    parts : tuple of str, default=()
        Experiments to run; all, if there are none.
    fast : bool, default=False
        Whether to run on a few seconds of motion in small images: a check, not results.
    seeds : int, default=3
        Number of seeds of the experiments whose errors are quoted with a spread.
    authors : str or None, default=None
        The authors' own data, ``ankurDataPoseSilhouette.mat``, on which to run as well.
    video : str or None, default=None
        A film of a fixed camera, for Figs. 11, 16 and 19.
    root : str, default="recordings/paper"
        Folder of such runs.
    name : str or None, default=None
        Folder in it; by default ``fast`` or ``whole``. What is finished there is not done again.
    """

    parts: tuple[str, ...] = ()
    fast: bool = False
    seeds: int = 3
    authors: str | None = None
    video: str | None = None
    root: str = "recordings/paper"
    name: str | None = None
    experiment_overrides: tuple[str, ...] = field(default=(), metadata={"given": True})

    def __post_init__(self) -> None:
        if not isinstance(self.seeds, int) or self.seeds < 1:
            raise InputError(f"paper.seeds must be a positive integer, not {self.seeds}")


def parse(arguments: Sequence[str]) -> PaperOptions:
    """Read the arguments of ``silpose paper``.

    Parameters
    ----------
    arguments : sequence of str
        ``paper.NAME=value``, and settings of experiments.

    Raises
    ------
    InputError
        If there is no such setting, or its value is of another kind.
    """
    own: dict[str, Any] = {}
    others = []
    known = [each.name for each in fields(PaperOptions) if not each.metadata]
    for argument in arguments:
        key, equals, text = argument.partition("=")
        if not equals:
            raise InputError(f"cannot read '{argument}': settings are given as key=value")
        if not key.startswith("paper."):
            others.append(argument)
            continue
        name = key.removeprefix("paper.")
        if name not in known:
            raise InputError(f"there is no setting '{key}'{nearest(name, known)}")
        own[name] = _value(key, name, text)
    return PaperOptions(**own, experiment_overrides=tuple(others))


def _value(key: str, name: str, text: str) -> Any:
    """Read a value as YAML does, but for paths and names, which are any text."""
    if name in ("authors", "video", "root", "name"):
        return text
    try:
        value = yaml.safe_load(text)
    except yaml.YAMLError as error:
        raise InputError(f"cannot read '{key}={text}': it is no value") from error
    if name == "parts":
        return tuple(map(str, value if isinstance(value, list) else [value]))
    kind = bool if name == "fast" else int
    if type(value) is not kind:
        raise InputError(f"{key} must be {'true or false' if kind is bool else 'a number'}")
    return value

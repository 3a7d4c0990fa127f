"""The components of an experiment, built from its settings."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any

from omegaconf import DictConfig

from silpose.app.build import build, build_alternative, build_candidates
from silpose.app.config import plain
from silpose.app.registry import COMPONENTS
from silpose.core.digest import digest
from silpose.core.known_results import KnownResults
from silpose.dataset import Renderer
from silpose.experiments.setup import Components
from silpose.motion import MotionSource

_RENDERED_WITH = ("body", "camera", "scenes", "degradation")
_TRAINED_BY = ("motion", "descriptor", "regression", "tracking", "fitting", "seed")
_DESCRIBED_BY = ("motion", "silhouette", "dataset", "descriptor", "seed")


def build_components(settings: DictConfig) -> Components:
    """Build all components of an experiment.

    Parameters
    ----------
    settings : DictConfig
        As `silpose.app.config.load` composes them.

    Returns
    -------
    components : Components

    Raises
    ------
    InputError
        If a setting is wrong; it is named in full.
    """
    given = plain(settings)
    dataset, silhouette = dict(given["dataset"]), dict(given["silhouette"])
    kept = {"cache": dataset.pop("cache", None)}
    described = {name: given[name] for name in _DESCRIBED_BY} | {"dataset": dict(dataset)}
    rendered = {n: build(f"silhouette.{n}", silhouette.pop(n, {})) for n in _RENDERED_WITH}
    source = build_alternative("motion", given["motion"])
    split = build_alternative("dataset", dataset)
    video = partial(build, "silhouette.video", silhouette.pop("video", {}))
    trained_by = {name: given[name] for name in _TRAINED_BY} | {"dataset": dict(dataset)}
    trained_by["silhouette"] = {name: given["silhouette"][name] for name in _RENDERED_WITH}
    return Components(
        dataset=split,
        renderer=Renderer(source, **rendered),
        camera=rendered["camera"],
        masks=build("silhouette", silhouette),
        descriptor=build_alternative("descriptor", given["descriptor"]),
        regression=_group_of_candidates("regression", given["regression"]),
        tracking=_group_of_candidates("tracking", given["tracking"]),
        fitting=build("fitting", given["fitting"]),
        seed=given["seed"],
        video=video,
        trained_by=lambda: digest(trained_by, source.files()),
        known=partial(build, "dataset", kept, source=source, described=described),
    )


def _group_of_candidates(group: str, settings: Mapping[str, Any]) -> Any:
    """Build a group whose parts are chosen among candidates."""
    rest = dict(settings)
    parts: dict[str, Any] = {}
    for name, component in COMPONENTS.items():
        above, _, own = name.rpartition(".")
        if above == group:
            make = build_candidates if component.candidates else build
            parts[own] = make(name, rest.pop(own, {}))
    return build(group, rest, **parts)


def known_results(
    source: MotionSource, described: object, *, cache: str | None = "${recording.root}/.cache"
) -> KnownResults:
    """Find what runs before have computed of the same data.

    Parameters
    ----------
    source : MotionSource
        Where the motion is from.
    described : object
        All settings that descriptors depend on.
    cache : str or None, default="${recording.root}/.cache"
        Folder where descriptors, and settings that were chosen with them, are kept and, if
        nothing changed, used again; None keeps nothing.
    """
    if cache is None:
        return KnownResults()
    return KnownResults(Path(cache), digest(described, source.files()))

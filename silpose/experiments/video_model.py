"""The model that films are fitted with: given, found in the user's cache folder, or trained."""

from __future__ import annotations

from dataclasses import dataclass, replace

from rich.console import Console

from silpose.core.errors import InputError
from silpose.core.stages import stage
from silpose.experiments.setup import Components, fitter_of_model, prepare_tracking
from silpose.model import ModelCache, PoseModel, load


@dataclass(frozen=True, eq=False)
class VideoModel:
    """A model with a fitter, and where it is from.

    Attributes
    ----------
    model : PoseModel
    origin : str
        In words, for the summary.
    given : str or None, default=None
        Its path, if it was given.
    unkept : PoseModel or None, default=None
        The model, if it is kept nowhere else.
    """

    model: PoseModel
    origin: str
    given: str | None = None
    unkept: PoseModel | None = None


def video_model(components: Components, given: str | None, folder: str | None) -> VideoModel:
    """Find the model, or train it once.

    Parameters
    ----------
    components : Components
    given : str or None
        Path of a model of another run.
    folder : str or None
        Where trained models are kept; None is the user's cache folder.

    Raises
    ------
    InputError
        If the model that is given has no fitter.
    """
    if given is not None:
        model = load(given)
        if model.fitter is None:
            raise InputError(
                f"the model '{given}' has no fitter: train it with fitting.enabled=true, or leave "
                "out model=…"
            )
        # Of a film's camera nothing is known, whatever was known of those in training.
        own = replace(model, fitter=model.fitter.with_options(components.fitting))
        return VideoModel(own, f"model '{given}'", given)
    cache = ModelCache.of(components.trained_by(), folder)
    with stage("model"):
        known = cache.fetch()
        if known is not None:
            return VideoModel(known, f"model found in '{cache.file}'")
        Console(stderr=True).print(
            "A model for films is trained first, once, in about three minutes.", style="dim"
        )
        trained = _train(components)
        if cache.store(trained):
            return VideoModel(trained, f"model trained, and kept in '{cache.file}'")
    return VideoModel(trained, "model trained", unkept=trained)


def _train(components: Components) -> PoseModel:
    training = prepare_tracking(components)
    ridge, tracker = training.ridge, training.tracker
    fitter = fitter_of_model(components, training.described, ridge, tracker)
    return training.described.model(ridge, tracker, fitter)

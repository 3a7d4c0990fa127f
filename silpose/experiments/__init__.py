"""Experiments: one file each, a short story that calls the rooms in order."""

from collections.abc import Callable

from silpose.experiments.predict import predict
from silpose.experiments.rooms import OwnMasks, Rooms
from silpose.experiments.single_image import single_image

EXPERIMENTS: dict[str, Callable[..., None]] = {"predict": predict, "single_image": single_image}

__all__ = ["EXPERIMENTS", "OwnMasks", "Rooms", "predict", "single_image"]

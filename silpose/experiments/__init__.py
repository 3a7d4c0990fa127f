"""Experiments: one file each, a short story that calls the rooms in order."""

from collections.abc import Callable

from silpose.experiments.bridges import bridges
from silpose.experiments.contact_sheet import contact_sheet
from silpose.experiments.feature_selection import feature_selection
from silpose.experiments.lookalikes import lookalikes
from silpose.experiments.parts import parts
from silpose.experiments.predict import predict
from silpose.experiments.regressors import regressors
from silpose.experiments.rooms import OwnMasks, Rooms
from silpose.experiments.shelf import Shelf
from silpose.experiments.single_image import single_image
from silpose.experiments.training_data import training_data

EXPERIMENTS: dict[str, Callable[..., None]] = {
    experiment.__name__: experiment
    for experiment in (
        bridges,
        contact_sheet,
        feature_selection,
        lookalikes,
        parts,
        predict,
        regressors,
        single_image,
        training_data,
    )
}

__all__ = ["EXPERIMENTS", "OwnMasks", "Rooms", "Shelf"]

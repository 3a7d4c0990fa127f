"""Experiments: one file each, a short story that calls the rooms in order."""

from collections.abc import Callable

from silpose.experiments.ambiguity import ambiguity
from silpose.experiments.bridges import bridges
from silpose.experiments.damping import damping
from silpose.experiments.extinction import extinction
from silpose.experiments.feature_selection import feature_selection
from silpose.experiments.initialisation import initialisation
from silpose.experiments.kernel_widths import kernel_widths
from silpose.experiments.mixture import mixture
from silpose.experiments.parts import parts
from silpose.experiments.predict import predict
from silpose.experiments.regressors import regressors
from silpose.experiments.rooms import OwnMasks, Rooms
from silpose.experiments.single_image import single_image
from silpose.experiments.tracking import tracking

EXPERIMENTS: dict[str, Callable[..., None]] = {
    experiment.__name__: experiment
    for experiment in (
        ambiguity,
        bridges,
        damping,
        extinction,
        feature_selection,
        initialisation,
        kernel_widths,
        mixture,
        parts,
        predict,
        regressors,
        single_image,
        tracking,
    )
}

__all__ = ["EXPERIMENTS", "OwnMasks", "Rooms"]

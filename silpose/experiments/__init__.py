"""Experiments: one file each, a short story that calls the rooms in order."""

from collections.abc import Callable

from silpose.experiments.ambiguity import ambiguity
from silpose.experiments.bridges import bridges
from silpose.experiments.contact_sheet import contact_sheet
from silpose.experiments.damping import damping
from silpose.experiments.descriptor_choices import descriptor_choices
from silpose.experiments.descriptor_robustness import descriptor_robustness
from silpose.experiments.descriptor_space import descriptor_space
from silpose.experiments.extinction import extinction
from silpose.experiments.feature_selection import feature_selection
from silpose.experiments.hypotheses import hypotheses
from silpose.experiments.initialisation import initialisation
from silpose.experiments.kernel_widths import kernel_widths
from silpose.experiments.lookalikes import lookalikes
from silpose.experiments.mixture import mixture
from silpose.experiments.parts import parts
from silpose.experiments.predict import predict
from silpose.experiments.regressors import regressors
from silpose.experiments.setup import Components, OwnMasks
from silpose.experiments.similarity import similarity
from silpose.experiments.single_image import single_image
from silpose.experiments.tracking import tracking
from silpose.experiments.training_data import training_data
from silpose.model.descriptor_cache import DescriptorCache

EXPERIMENTS: dict[str, Callable[..., None]] = {
    experiment.__name__: experiment
    for experiment in (
        *(single_image, predict, contact_sheet, lookalikes, training_data),
        *(descriptor_space, similarity, descriptor_robustness, descriptor_choices),
        *(bridges, parts, feature_selection, regressors),
        *(tracking, extinction, damping, kernel_widths, initialisation),
        *(mixture, ambiguity, hypotheses),
    )
}

__all__ = ["EXPERIMENTS", "Components", "DescriptorCache", "OwnMasks"]

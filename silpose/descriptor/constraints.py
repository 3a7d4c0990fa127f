"""Allowed values of the parameters of `ShapeContextHistogram`."""

from __future__ import annotations

from silpose.core.parameters import (
    NUMBER_OF_JOBS,
    POSITIVE,
    POSITIVE_INTEGER,
    PROBABILITY,
    SEED,
    Constraint,
    Constraints,
    one_of,
)
from silpose.descriptor.codebook import METHODS
from silpose.descriptor.description import BOUNDARIES

NORMALISATIONS = ("sum", "mean", "none")
_FARTHEST = 10  # silhouette sizes: no two points of one are that far apart

CONSTRAINTS: Constraints = {
    "boundary": one_of(*BOUNDARIES),
    "edge_points": POSITIVE_INTEGER.or_none(),
    "spacing": POSITIVE.or_none(),
    "closing": PROBABILITY,
    "angular_bins": POSITIVE_INTEGER,
    "radial_bins": POSITIVE_INTEGER,
    "radius": Constraint(
        f"above 0 and at most {_FARTHEST}",
        lambda value: POSITIVE.holds(value) and value <= _FARTHEST,
    ),
    "inner_radius": Constraint(
        "between 0 and 1", lambda value: POSITIVE.holds(value) and value < 1
    ),
    "codebook_size": POSITIVE_INTEGER,
    "codebook_method": one_of(*METHODS),
    "voters": POSITIVE_INTEGER.or_none(),
    "vote_width": POSITIVE,
    "normalisation": one_of(*NORMALISATIONS),
    "max_contexts": POSITIVE_INTEGER,
    "n_jobs": NUMBER_OF_JOBS,
    "random_state": SEED,
}

"""What the parameters of a mixture may be."""

from __future__ import annotations

from silpose.core.parameters import (
    FLAG,
    NOT_NEGATIVE,
    POSITIVE,
    POSITIVE_INTEGER,
    PROBABILITY,
    SEED,
    Constraint,
    Constraints,
    one_of,
)
from silpose.regression.regressor import Regressor

CONSTRAINTS: Constraints = {
    "clusters": POSITIVE_INTEGER,
    "dimensions": POSITIVE_INTEGER,
    "damping": POSITIVE,
    "temperature": POSITIVE,
    "noise_width": POSITIVE,
    "outlier_probability": PROBABILITY,
    "floor": POSITIVE,
    "agreement": POSITIVE,
    "calibration_exponent": POSITIVE,
    "point_estimate": one_of("mode", "mean"),
    "shared_width": POSITIVE,
    "shared_temperature": POSITIVE,
    "smallest": POSITIVE_INTEGER,
    "max_iter": POSITIVE_INTEGER,
    "tol": NOT_NEGATIVE,
    "shared": Constraint(
        "a Regressor or None", lambda value: value is None or isinstance(value, Regressor)
    ),
    "hellinger": FLAG,
    "random_state": SEED,
}

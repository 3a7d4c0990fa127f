"""Parts of an estimator that None stands for: their parameters can be set all the same."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar, Self

Parts = Mapping[str, type[Any]]
"""Class of each part, by the name of the parameter that is one, or None for a default one."""


class DefaultParts:
    """Mix-in for `set_params`: ``basis__width=2`` also where ``basis`` is None.

    A class names its parts, and the class of each, in ``default_parts``. It must come before
    `sklearn.base.BaseEstimator` in the order of bases.
    """

    default_parts: ClassVar[Parts] = {}

    def set_params(self, **params: Any) -> Self:
        """Set parameters, those of parts as ``part__parameter``, as scikit-learn does."""
        for name, create in self.default_parts.items():
            own = any(key.startswith(f"{name}__") for key in params)
            if own and params.get(name, getattr(self, name)) is None:
                params[name] = create()
        super().set_params(**params)  # type: ignore[misc]
        return self

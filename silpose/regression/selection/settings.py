"""Settings of every regression method: one value, or a list for validation to choose from."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from silpose.core.errors import InputError
from silpose.regression.basis import Basis

METHODS = ("ridge", "rvm", "rvm_N (at most N % kept)", "svm")


@dataclass(frozen=True)
class BasisSettings:
    """Which basis functions, and the width factors to choose from."""

    kernel: str | None = "gaussian"
    linear: bool = False
    centres: int = 2700
    hellinger: bool = True
    normalised: bool = False
    random_state: int | None = 0
    width: float | list[float] = field(default_factory=lambda: [1.0, 2.0, 4.0, 8.0])

    def __post_init__(self) -> None:
        numbers(self.width, "basis.width")

    def basis(self, width: float) -> Basis:
        """Make the basis of one width."""
        return Basis(
            self.kernel,
            self.linear,
            self.centres,
            width,
            self.hellinger,
            self.normalised,
            self.random_state,
        )

    def widths(self) -> list[float]:
        """Widths to choose from; without kernels there is nothing to choose."""
        return numbers(self.width, "basis.width") if self.kernel else [1.0]


@dataclass(frozen=True)
class RidgeSettings:
    """The λ, or those to choose from."""

    damping: float | list[float] = field(default_factory=lambda: [0.01, 0.03, 0.1, 0.3, 1.0])

    def __post_init__(self) -> None:
        numbers(self.damping, "ridge.damping")


@dataclass(frozen=True)
class RvmSettings:
    """The ν, or those to choose from, and when to stop.

    Chosen is the sparsest regressor whose validation error is at most `slack` above the best.
    """

    nu: float | list[float] = field(default_factory=lambda: [8.0, 16.0, 32.0, 64.0])
    slack: float = 0.03
    max_iter: int = 200
    tol: float = 1e-2

    def __post_init__(self) -> None:
        numbers(self.nu, "rvm.nu")


@dataclass(frozen=True)
class SvmSettings:
    """The half width of the tube, in the outputs' units, and the C's to choose from."""

    tube: float = 1.0
    penalty: float | list[float] = 3.0

    def __post_init__(self) -> None:
        numbers(self.penalty, "svm.penalty")


def check_methods(methods: Sequence[str]) -> None:
    """Refuse a name that is no method, before hours are spent on the others."""
    for method in methods:
        share(method)


def share(method: str) -> float | None:
    """Share of kernels that a method's name allows; None if it does not say."""
    if method in ("ridge", "rvm", "svm"):
        return None
    percent = re.fullmatch(r"rvm_(\d+)", method)
    if not percent or not 0 < int(percent[1]) <= 100:
        raise InputError(f"there is no method '{method}'; there are {', '.join(METHODS)}")
    return int(percent[1]) / 100


def numbers(value: float | Iterable[float], name: str) -> list[float]:
    """Make a list of one value or several, all positive."""
    values = [value] if isinstance(value, int | float) else list(value)
    if not values or not all(isinstance(v, int | float) and v > 0 for v in values):
        raise InputError(f"regression.{name} is to be positive numbers, not {value!r}")
    return [float(v) for v in values]

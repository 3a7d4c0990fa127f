"""Training takes: pairs of arrays, or functions that read a pair whenever it is needed."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.errors import InputError
from silpose.core.types import Array
from silpose.tracking.checks import check_finite, check_not_negative, check_table, listed, numbers

FRAMES = 4096
"""Frames of a block: enough for linear algebra, few enough for memory."""

GivenTake = tuple[ArrayLike, ArrayLike] | Callable[[], tuple[ArrayLike, ArrayLike]]
"""Descriptors (F, d) and poses (F, D) of a take, or a function that returns them."""

GivenTakes = Sequence[GivenTake]


@dataclass(frozen=True)
class Frames:
    """Some frames of training takes, one after the other.

    Attributes
    ----------
    z, x : ndarray, shapes (F, d) and (F, D)
        Descriptors and poses.
    following : ndarray, shape (F, D)
        The pose after each; after a take's last, its extrapolation at constant velocity.
    """

    z: Array
    x: Array
    following: Array


class TrainingTakes(Sequence[tuple[Array, Array]]):
    """Takes that have been checked; those that are functions are called anew in every pass.

    Parameters
    ----------
    takes : sequence
        Each a pair of descriptors (F, d) and poses (F, D), or a function without arguments that
        returns one, such as the blocks of `silpose.regression.stored_blocks`.

    Attributes
    ----------
    lengths : list of int
        Number of frames of each.

    Raises
    ------
    InputError
        If there are none, or one cannot be used; it is named by its index.
    """

    def __init__(self, takes: Any) -> None:
        self._takes: list[GivenTake] = []
        self._columns: tuple[int, int] | None = None
        self.lengths: list[int] = []
        for k, take in enumerate(listed(takes)):
            z, x = self._checked(k, take)
            self._columns = z.shape[1], x.shape[1]
            self._takes.append(take if callable(take) else (z, x))
            self.lengths.append(len(x))
        if not sum(self.lengths):
            raise InputError("there are no training takes: give at least one pair (z, x) of frames")

    @classmethod
    def of(cls, takes: Any) -> TrainingTakes:
        """Return takes that have been checked already as they are, and check others."""
        return takes if isinstance(takes, cls) else cls(takes)

    @property
    def columns(self) -> tuple[int, int]:
        """Number of columns of descriptors and of poses, d and D."""
        assert self._columns is not None  # there is a take
        return self._columns

    @property
    def poses(self) -> TakePoses:
        """The poses of each take, read when needed."""
        return TakePoses(self)

    @property
    def in_memory(self) -> bool:
        """Whether all are arrays."""
        return not any(callable(take) for take in self._takes)

    @property
    def given(self) -> list[GivenTake]:
        """The takes as pairs of arrays, or functions that return one."""
        return self._takes

    def __len__(self) -> int:
        return len(self._takes)

    def __getitem__(self, k: Any) -> Any:
        take = self._takes[k]
        return self._checked(k, take) if callable(take) else take

    def __iter__(self) -> Iterator[tuple[Array, Array]]:
        return (self[k] for k in range(len(self)))

    def blocks(self, most: int = FRAMES) -> Iterator[Frames]:
        """Iterate over all frames, so many at a time."""
        held: list[Frames] = []
        count = 0
        for z, x in self:
            following, start = _following(x), 0
            while start < len(x):
                stop = min(len(x), start + most - count)
                held.append(Frames(z[start:stop], x[start:stop], following[start:stop]))
                count, start = count + stop - start, stop
                if count == most:
                    yield _joined(held)
                    held, count = [], 0
        if held:
            yield _joined(held)

    def _checked(self, k: int, take: Any) -> tuple[Array, Array]:
        try:
            z, x = take() if callable(take) else take
        except (TypeError, ValueError):
            raise InputError(
                f"take {k} is no pair: give descriptors and poses (z, x) of each take"
            ) from None
        z, x = numbers(z, f"descriptors of take {k}"), numbers(x, f"poses of take {k}")
        columns = self._columns or (_width(z), _width(x))
        check_table(z, f"descriptors of take {k}", columns[0])
        check_table(x, f"poses of take {k}", columns[1])
        if len(z) != len(x):
            raise InputError(
                f"take {k} has {len(z)} descriptors and {len(x)} poses: give one of each a frame"
            )
        check_finite(z, f"descriptors of take {k}", "leave out frames without a person")
        check_finite(x, f"poses of take {k}", "leave out frames without a pose")
        check_not_negative(z, f"descriptors of take {k}")
        return z, x


class TakePoses(Sequence[Array]):
    """Poses (F, D) of each of some takes, which are read when needed."""

    def __init__(self, takes: TrainingTakes) -> None:
        self._takes = takes

    def __len__(self) -> int:
        return len(self._takes)

    def __getitem__(self, k: Any) -> Any:
        return self._takes[k][1]


def checked_poses(poses: Any) -> Sequence[Array]:
    """Check the poses (F, D) of training takes, without descriptors."""
    if isinstance(poses, TakePoses):
        return poses
    found: list[Array] = []
    for k, take in enumerate(listed(poses)):
        x = numbers(take, f"poses of take {k}")
        check_table(x, f"poses of take {k}", found[0].shape[-1] if found else _width(x))
        check_finite(x, f"poses of take {k}", "leave out frames without a pose")
        found.append(x)
    return found


def checked_takes(takes: Any) -> list[tuple[Array, Array]]:
    """Check training takes; return descriptors (F, d) and poses (F, D) of each, in memory."""
    return list(TrainingTakes(takes))


def _width(values: Array) -> int:
    """Return the number of columns, or 0 for what has none."""
    return values.shape[1] if values.ndim == 2 else 0


def _following(take: Array) -> Array:
    """Return the pose after each; after the last, its extrapolation at constant velocity."""
    if not len(take):
        return take
    last = 2 * take[-1:] - take[-2:-1] if len(take) > 1 else take
    return np.vstack([take[1:], last])


def _joined(parts: list[Frames]) -> Frames:
    if len(parts) == 1:
        return parts[0]
    z, x, following = (
        np.concatenate([getattr(part, name) for part in parts]) for name in ("z", "x", "following")
    )
    return Frames(z, x, following)

"""Which masks are degraded, how, and how much: settings, drawn anew for every frame."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from zlib import crc32

import numpy as np

from silpose.core.errors import InputError
from silpose.silhouette.degradations import Mask, check, degrade

WHOLE = "none"  # among the kinds: leaves some frames as they are


class Degradation:
    """Degrades masks by kinds and strengths drawn for every frame.

    Parameters
    ----------
    train, test : list of str
        Kinds (`silpose.silhouette.DEGRADATIONS`, and ``"none"``) that the masks of training and
        validation, and of testing, suffer: each frame one of them. Without any they stay whole.
    strength : float or [float, float]
        0 to 1, or the lowest and highest to draw from.
    seed : int
        The same seed, sequence and frame give the same damage.
    """

    def __init__(
        self,
        train: list[str] | None = None,
        test: list[str] | None = None,
        strength: float | list[float] = 0.5,
        seed: int = 0,
    ) -> None:
        self.train = train or []
        self.test = test or []
        self.strength = strength
        self.seed = seed
        bounds = [strength] if isinstance(strength, int | float) else list(strength)
        if len(bounds) not in (1, 2) or not all(isinstance(b, int | float) for b in bounds):
            raise InputError(f"a strength is one number or two, lowest and highest, not {strength}")
        self._low, self._high = sorted((bounds[0], bounds[-1]))
        for kind in {*self.train, *self.test, "holes"} - {WHOLE}:
            for bound in bounds:
                check(kind, bound)

    def degrader(self, kinds: Sequence[str]) -> Callable[[str], Callable[[Mask, int], Mask] | None]:
        """Give what degrades masks by some kinds, `train` or `test`.

        Returns
        -------
        degrader : callable
            From the name of a sequence to a function of a mask and its frame; None if there are no
            kinds.
        """
        if not kinds:
            return lambda name: None
        return lambda name: partial(self._one, kinds, name)

    def _one(self, kinds: Sequence[str], name: str, mask: Mask, frame: int) -> Mask:
        rng = np.random.default_rng([self.seed, crc32(name.encode()), int(frame)])
        kind = kinds[int(rng.integers(len(kinds)))]
        strength = rng.uniform(self._low, self._high)
        return mask if kind == WHOLE else degrade(mask, kind, strength, rng)

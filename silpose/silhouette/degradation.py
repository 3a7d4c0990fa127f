"""Which masks are degraded, how, and how much: settings, drawn anew for every frame."""

from __future__ import annotations

from collections.abc import Sequence
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

from silpose.errors import InputError
from silpose.silhouette.degrade import Mask, check, degrade

WHOLE = "none"  # among the kinds: leaves some frames as they are


class Degradation:
    """Degrades masks by kinds and strengths drawn for every frame.

    Parameters
    ----------
    train, test : list of str
        Kinds (`silpose.silhouette.degrade.KINDS`, and ``"none"``) that the masks of training and
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

    def apply(
        self, masks: Sequence[Mask] | Mask, kinds: Sequence[str], name: str
    ) -> NDArray[np.uint8]:
        """Degrade the masks of one sequence.

        Parameters
        ----------
        masks : sequence of ndarray, each (H, W)
        kinds : sequence of str
            `train` or `test`.
        name : str
            Of the sequence.
        """
        return np.stack([self._one(m, kinds, name, frame) for frame, m in enumerate(masks)])

    def _one(self, mask: Mask, kinds: Sequence[str], name: str, frame: int) -> Mask:
        rng = np.random.default_rng([self.seed, crc32(name.encode()), frame])
        kind = kinds[int(rng.integers(len(kinds)))]
        strength = rng.uniform(self._low, self._high)
        return mask if kind == WHOLE else degrade(mask, kind, strength, rng)

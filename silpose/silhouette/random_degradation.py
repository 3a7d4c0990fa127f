"""Degradations whose kind and strength are drawn for every frame, or once for a take."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from zlib import crc32

import numpy as np

from silpose.core.errors import InputError
from silpose.silhouette.degradations import Mask, check, degrade
from silpose.silhouette.out_of_frame import OUT_OF_FRAME, out_of_frame

UNCHANGED = "none"
"""Among the kinds, leaves some frames as they are."""

Degrader = Callable[[Mask, int], Mask]
"""From a mask and its frame to the degraded mask."""


class Degradation:
    """Random degradation of masks, of a kind and strength drawn for every frame or take.

    Parameters
    ----------
    train : list of str or None, default=None
        Kinds to draw from for the masks of training and validation, one for each frame:
        ``boundary_noise``, ``holes``, ``missing_limb``, ``swollen_limb``, ``shadow``,
        ``horizontal_occluder``, ``vertical_occluder``, ``low_resolution``, ``frame_cut``, ``bag``,
        ``coat``, ``out_of_frame``, by which the image's edge cuts the person, and ``none``. None
        leaves all masks as they are.
    test : list of str or None, default=None
        Kinds to draw from for the masks of testing.
    strength : float or [float, float], default=0.5
        0 to 1, or the lowest and highest to draw from.
    seed : int, default=0
        The same seed, take and frame give the same damage.
    lasting : bool, default=False
        Draw kind, strength and place once for each take, as of an occluder that stays where it is,
        a bag that is carried, or a coat: the place is the same relative to the person. Otherwise
        every frame is damaged by itself.

    Raises
    ------
    InputError
        If there is no such kind, or a strength is outside 0 to 1.
    """

    def __init__(
        self,
        *,
        train: list[str] | None = None,
        test: list[str] | None = None,
        strength: float | list[float] = 0.5,
        seed: int = 0,
        lasting: bool = False,
    ) -> None:
        self.train = train or []
        self.test = test or []
        self.strength = strength
        self.seed = seed
        self.lasting = lasting
        bounds = [strength] if isinstance(strength, int | float) else list(strength)
        if len(bounds) not in (1, 2) or not all(isinstance(b, int | float) for b in bounds):
            raise InputError(
                f"a degradation's strength must be a number or [lowest, highest], not {strength}"
            )
        self._low, self._high = sorted((bounds[0], bounds[-1]))
        for kind in {*self.train, *self.test, "holes"} - {UNCHANGED, OUT_OF_FRAME}:
            for bound in bounds:
                check(kind, bound)

    def degrader(self, kinds: Sequence[str], take: str) -> Degrader | None:
        """Make the function that degrades the masks of one take.

        Parameters
        ----------
        kinds : sequence of str
            `train` or `test`.
        take : str
            Name of the take.

        Returns
        -------
        degrader : callable or None
            From a mask and its frame to the degraded mask; None if there are no kinds.
        """
        return partial(self._degraded, kinds, take) if kinds else None

    def _degraded(self, kinds: Sequence[str], take: str, mask: Mask, frame: int) -> Mask:
        drawn_for = [self.seed, crc32(take.encode())]
        rng = np.random.default_rng(drawn_for if self.lasting else [*drawn_for, int(frame)])
        kind = kinds[int(rng.integers(len(kinds)))]
        strength = rng.uniform(self._low, self._high)
        if kind == OUT_OF_FRAME:
            return out_of_frame(mask, strength, rng)
        return mask if kind == UNCHANGED else degrade(mask, kind, strength, rng)

"""The decision how the pixels of a source become masks, once for all its pictures."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from silpose.core.errors import InputError
from silpose.core.types import Array
from silpose.silhouette.masks.cut_outs import plane_of_cut_outs
from silpose.silhouette.masks.encoding import Encoding, NoMasksError
from silpose.silhouette.masks.labels import Labels, choose_labels, is_label_image
from silpose.silhouette.masks.levels import Levels
from silpose.silhouette.masks.mask_source import MaskSource
from silpose.silhouette.masks.picture import Picture, Pixels
from silpose.silhouette.masks.planes import Plane, choose_plane
from silpose.silhouette.masks.thresholds import (
    Threshold,
    bright_border,
    is_shadow,
    like_masks,
    shadow_of,
    shows_nothing,
    solid_levels,
    surrounds,
    two_levels,
)

_DARK, _BRIGHT = 50, 205  # beyond them, values span 0 to 255
_OVERSHOOT = 0.2  # of the highest value: how far below 0 interpolation may go
_CLEAN = 3  # values; compression leaves more
_SHADOW = 127
_DARKEST = 64  # up to it, whole numbers are no brightness
_UNCLEAR = (0.35, 0.65)  # share of the border that is bright where nothing is certain
_HALVED = "what is not known given to what is nearest"
_SEGMENT = "segment them first"


def decide(pictures: Sequence[Picture], options: MaskSource, source: str) -> Encoding:
    """Decide how the pictures of a source become masks.

    Parameters
    ----------
    pictures : sequence of Picture
    options : MaskSource
    source : str
        What the source is called in messages.

    Raises
    ------
    InputError
        If the pictures are no masks, or of several people with labels of their own.
    """
    plane = choose_plane(pictures, source, options.label is not None)
    planes = [plane.of(picture) for picture in pictures]
    if options.threshold is not None:
        rule = Threshold(options.threshold, bool(options.inverted))
        return Encoding(plane, rule, f"{plane.name} above {options.threshold:g}")
    levels = Levels.of(planes)
    lossy = any(picture.lossy for picture in pictures)
    return _Decision(plane, planes, levels, pictures, options, source).encoding(lossy)


@dataclass(frozen=True)
class _Decision:
    plane: Plane
    planes: Sequence[Pixels]
    levels: Levels
    pictures: Sequence[Picture]
    options: MaskSource
    source: str

    def encoding(self, lossy: bool) -> Encoding:
        present = self.levels.present
        if len(present) == 1:
            return self._constant(present[0])
        if self.options.label is not None:
            return self._labels(present)
        if self.plane.labels:
            if not is_label_image(self.levels):
                raise NoMasksError(self._no_masks("colour images"))
            return self._labels(present)
        if len(present) == 2:
            return self._between(present[0], present[1])
        if lossy and shows_nothing(self.levels):
            return self._nothing()
        compressed = lossy and len(present) > _CLEAN
        if self.plane.colours or compressed or self._are_scores() or not self.levels.exact:
            return self._soft()
        solid = solid_levels(self.levels)
        if is_shadow(solid):
            if surrounds(self.planes, solid):
                rule = Labels((float(solid[2]),), float(solid[1]))
                return Encoding(self.plane, rule, f"{self.plane.name}: a trimap, {_HALVED}")
            return self._between(solid[0], solid[2], "soft", shadow=solid[1])
        return self._labels(present) if self._are_numbers(solid) else self._soft()

    def _are_scores(self) -> bool:
        """Whether values are scores around 0, and do not only overshoot it by interpolation."""
        low, high = self.levels.present[[0, -1]]
        return self.planes[0].dtype.kind == "f" and bool(low < -_OVERSHOOT * high < 0)

    def _are_numbers(self, solid: Array) -> bool:
        """Whether values are labels: too dark to be shades, or most of them areas of their own."""
        present = self.levels.present
        whole = bool((present == np.round(present)).all())
        if whole and present[-1] <= _DARKEST:
            return True
        areas = len(solid) > 2 and 2 * len(solid) >= len(present)
        return areas and is_label_image(self.levels)

    def _constant(self, value: float) -> Encoding:
        words = f"{self.plane.name}, all {value:g}"
        return Encoding(self.plane, Threshold(0.0 if value > 0 else value), words)

    def _nothing(self) -> Encoding:
        low, high = self.levels.present[[0, -1]]
        words = f"{self.plane.name} from {low:g} to {high:g}: nothing to be seen"
        doubt = f"the brightness of {self.source} goes from {low:g} to {high:g} only: all blank"
        return Encoding(self.plane, Threshold(float(high)), words, (doubt,))

    def _labels(self, values: Array) -> Encoding:
        rule, words = choose_labels(
            self.levels, values.tolist(), self.planes, self.options.label, self.source
        )
        return Encoding(self.plane, rule, f"{self.plane.name}: {words}")

    def _soft(self) -> Encoding:
        levels = self.levels
        low, high = levels.present[[0, -1]]
        if self._are_scores():
            words = f"{self.plane.name} from {low:g} to {high:g}, scores: above 0"
            return Encoding(self.plane, Threshold(0.0), words)
        if self.plane.colours and shows_nothing(levels):
            return self._nothing()
        shadow = shadow_of(levels)
        like = like_masks(levels, shadow)
        photos = not like.all()
        if photos or shadow is None:
            cut_outs = plane_of_cut_outs(self.pictures, no_masks=photos)
            if cut_outs is not None:
                return self._cut_out(cut_outs)
        if photos:
            raise self._photos(like)
        return self._between(*self._span(), "soft", shadow)

    def _cut_out(self, plane: Plane) -> Encoding:
        doubt = (
            f"{self.source} holds no masks, but pictures before one colour: {plane.name} is taken "
            "for the person"
        )
        return Encoding(plane, Threshold(0), plane.name, (doubt,))

    def _photos(self, like: NDArray[np.bool_]) -> InputError:
        """Give the error about photos; a single one among masks is named."""
        if like.mean() > 0.5:
            odd = self.pictures[int(np.argmin(like))].name
            return NoMasksError(
                f"'{odd}' of {self.source} is no mask, but a picture of many shades: remove it, or "
                "segment it as the others"
            )
        kind = "colour images" if self.plane.colours else "images of many shades"
        return NoMasksError(self._no_masks(kind))

    def _no_masks(self, kind: str) -> str:
        if self.plane.colours:
            how = (
                "the person is before one colour, say how far from it, of 255, by "
                "silhouette.threshold=40 (in Python threshold=40)"
            )
        else:
            how = (
                "they are masks, say what is the person by silhouette.threshold=128 (in Python "
                "threshold=128)"
            )
        return f"{self.source} holds no masks; these look like {kind}: {_SEGMENT}, or, if {how}"

    def _between(
        self, low: float, high: float, kind: str | None = None, shadow: float | None = None
    ) -> Encoding:
        """Separate two levels in the middle."""
        middle = (low + high) / 2
        inverted, doubts = self._inverted(middle)
        if shadow is not None:
            middle = (shadow + (low if inverted else high)) / 2
        doubts += self._weak(low, high, kind)
        words = f"{self.plane.name}"
        words += f", {kind}" if kind else f" {low:g} and {high:g}"
        words += f", shadows at {shadow:.0f}" if shadow is not None else ""
        words += f": {'dark, up to' if inverted else 'above'} {middle:g}"
        return Encoding(self.plane, Threshold(float(middle), inverted), words, doubts)

    def _weak(self, low: float, high: float, kind: str | None) -> tuple[str, ...]:
        """Doubt what is bright, where it may be but a shadow, or improbable."""
        if (low, high) == (0, _SHADOW):
            what = f"{high:g}, which background subtraction gives to shadows"
        elif kind and self.planes[0].dtype.kind == "f" and low >= 0 and high <= 0.5:
            what = f"{high:g}, and probabilities of a person are above 0.5"
        else:
            return ()
        return (
            f"the values of {self.source} reach {what}: they are taken for the person; say "
            "silhouette.threshold=… (in Python threshold=…) if that is wrong",
        )

    def _span(self) -> tuple[float, float]:
        """Levels of background and person: the usual ones of their type, if values reach them."""
        low, high = self.levels.present[[0, -1]]
        floats = self.planes[0].dtype.kind == "f"
        if not self.plane.colours and low >= -_OVERSHOOT * high:
            if floats and 0.5 < high <= 1 + _OVERSHOOT:
                return 0.0, 1.0
            bytes_ = floats or self.planes[0].dtype == np.uint8
            if bytes_ and low < _DARK and _BRIGHT < high < 255 * (1 + _OVERSHOOT):
                return 0.0, 255.0
        return two_levels(self.levels)

    def _inverted(self, middle: float) -> tuple[bool, tuple[str, ...]]:
        """Whether the person is dark, by the borders of the pictures."""
        if self.plane.colours:  # whose background is at 0
            return False, ()
        if self.options.inverted is not None:
            return self.options.inverted, ()
        share = bright_border(self.levels, middle)
        if _UNCLEAR[0] < share < _UNCLEAR[1]:
            taken = "dark" if share > 0.5 else "bright"
            return share > 0.5, (
                f"the borders of {self.source} are half bright, half dark; the person is taken to "
                f"be {taken}: say silhouette.inverted=true if the person is dark, =false if "
                "bright (in Python inverted=True or False)",
            )
        if share > 0.5:
            return True, (
                f"the background of {self.source} is bright: the dark part is taken for the "
                "person; say silhouette.inverted=false (in Python inverted=False) if that is wrong",
            )
        return False, ()

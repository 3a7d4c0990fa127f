"""`CameraMotion`: whether a camera that should stand still moves."""

from __future__ import annotations

from typing import NamedTuple

import cv2
import numpy as np

from silpose.core.types import Array, Mask
from silpose.silhouette.video.frame import Picture
from silpose.silhouette.video.scene_view import SceneView, gradient

_SURE = 5.0  # standard deviations of a shift from which it is one
_KNOWN = 0.3  # of the shift that is a motion: standard deviation below which there is none
_ALIKE, _UNLIKE = 0.75, 0.2  # correlation of the same scene, of detail beyond noise, and of another
_CELLS = 6  # along the longer side
_BETTER = 0.75  # of the lack of correlation without a shift, that is left by one
_FEW = 3  # one in so many cells may be of what moves in the scene:
_CLEAR = 4.0  # the others agree with a shift by so many standard deviations of noise
_ROUNDS, _SMALL = 4, 0.02  # refinements, and pixels from which there is no further one
_CORRELATED = 4.0  # neighbouring pixels whose noise is one
_PIXELS = 100  # that both pictures show of the scene, at least


class CameraMotion:
    """Compares pictures with the first one, or with one of a while ago, without the person.

    The shift that explains the scene's detail best is found by correlation, and refined [1]_. It
    is a motion of the camera if it is larger than its error, and explains most parts of the
    picture better than no shift does: what moves in the scene moves in one place. Weak texture, of
    which a part alone tells nothing, so tells of a shift as a whole.

    Parameters
    ----------
    shift : float
        Share of the longer side from which a shift is a motion.
    renew : int or None, default=None
        Pictures after which the reference is replaced; None keeps the first one.

    References
    ----------
    .. [1] B. D. Lucas, T. Kanade, "An iterative image registration technique", IJCAI 1981.
    """

    def __init__(self, shift: float, renew: int | None = None) -> None:
        self.shift = shift
        self.renew = renew
        self._reference: SceneView | None = None
        self._age = 0
        self._last = np.zeros(2)
        self._known = 0.0
        self._moved = False

    def step(self, picture: Picture, people: Mask | None = None) -> bool:
        """Whether the camera has moved since the reference; as before, where nothing tells.

        Parameters
        ----------
        picture : ndarray of uint8, shape (H, W, 3)
        people : ndarray of 0 and 1, shape (H, W), optional
            Left out, as they move in any case.
        """
        view, reference = SceneView.of(picture, people), self._reference
        self._age += 1
        if reference is None:
            self._reference = view
            return False
        still = np.zeros(2)
        starts = [still, _correlated(reference, view)]
        if self._last.any():
            starts.append(self._last)
        likely = max(starts, key=lambda start: _likeness(reference, view, start))
        best = _Shift.between(reference, view, likely)
        far, least = float(np.hypot(*best.pixels)), self.shift * max(view.detail.shape)
        if far > max(least, _SURE * best.deviation) and best.explains(reference, view):
            self._moved, self._last = True, best.pixels
        elif self._known > _ALIKE and best.likeness < _UNLIKE:
            self._moved = True  # so far that nothing shows the same
        elif far <= least and best.likeness > _ALIKE and best.deviation < _KNOWN * least:
            self._moved, self._last = False, still
            self._known = max(self._known, best.likeness)
        if self.renew is not None and self._age >= self.renew:
            self._reference, self._age, self._last, self._known = view, 0, still, 0.0
        return self._moved


class _Shift(NamedTuple):
    """A shift between two views, and how well it is known.

    Attributes
    ----------
    pixels : ndarray, shape (2,)
    deviation : float
        Standard deviation of its error.
    likeness : float
        Correlation of the one view and the other, shifted back.
    """

    pixels: Array
    deviation: float
    likeness: float

    @classmethod
    def between(cls, reference: SceneView, view: SceneView, start: Array) -> _Shift:
        """Find the shift near a start."""
        shift, deviation = start, np.inf
        for _ in range(_ROUNDS):
            moved, weight = reference.compared(view, shift)
            pixels = float(weight.sum())
            if pixels < _PIXELS:
                return cls(start, np.inf, -1.0)
            off = weight * (moved - reference.detail)
            slopes = np.stack([own.ravel() for own in gradient(moved, weight)])
            variance = float(np.vdot(off, off)) / pixels
            gram = slopes @ slopes.T + max(1e-3 * variance, 1e-9) * np.eye(2)
            step = np.clip(np.linalg.solve(gram, slopes @ off.ravel()), -2, 2)
            shift = shift - step
            covariance = _CORRELATED * variance * np.linalg.inv(gram)
            deviation = float(np.sqrt(np.linalg.eigvalsh(covariance)[-1]))
            if np.abs(step).max() < _SMALL:
                break
        return cls(np.asarray(shift, float), deviation, _likeness(reference, view, shift))

    def explains(self, reference: SceneView, view: SceneView) -> bool:
        """Whether the picture agrees with the shift better than with none, and most parts do."""
        before = _likeness(reference, view, np.zeros(2))
        if 1 - self.likeness > _BETTER * (1 - before):
            return False
        moved, seen = reference.compared(view, self.pixels)
        both = seen * view.weight
        off, still = both * (moved - reference.detail), both * (view.detail - reference.detail)
        side = max(1, max(off.shape) // _CELLS)
        size = -(-off.shape[1] // side), -(-off.shape[0] // side)
        gain = cv2.resize(still**2 - off**2, size, interpolation=cv2.INTER_AREA)
        rest = np.sort(gain.ravel())[: gain.size - gain.size // _FEW]
        variance = float(np.vdot(off, off)) / max(float(both.sum()), 1.0)
        noise = variance * np.sqrt(8 * _CORRELATED * len(rest)) / side
        return float(rest.sum()) > _CLEAR * noise


def _correlated(reference: SceneView, view: SceneView) -> Array:
    """Find the whole pixels by which a shifted view correlates best with the reference."""
    height, width = (cv2.getOptimalDFTSize(length) for length in reference.detail.shape)
    padded = np.zeros((2, height, width), np.float32)
    for own, other in zip(padded, (view, reference), strict=True):
        own[: other.detail.shape[0], : other.detail.shape[1]] = other.detail
    seen, expected = (cv2.dft(own) for own in padded)
    product = cv2.mulSpectrums(seen, expected, 0, conjB=True)
    correlation = np.asarray(cv2.idft(product, flags=cv2.DFT_REAL_OUTPUT))
    row, column = np.unravel_index(int(correlation.argmax()), correlation.shape)
    down, across = (int(k) - n * (2 * k >= n) for k, n in ((row, height), (column, width)))
    return np.array([across, down], float)


def _likeness(reference: SceneView, view: SceneView, shift: Array) -> float:
    moved, weight = reference.compared(view, shift)
    one, other = weight * reference.detail, weight * moved
    lengths = float(np.vdot(one, one)) * float(np.vdot(other, other))
    return float(np.vdot(one, other)) / max(float(np.sqrt(lengths)), 1e-9)

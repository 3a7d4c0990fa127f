"""Other descriptors, for comparison: Hu's moments, and principal components of the mask."""

from __future__ import annotations

from typing import ClassVar

import cv2
import numpy as np
from numpy.typing import NDArray
from sklearn.base import BaseEstimator, TransformerMixin
from sklearn.decomposition import PCA
from sklearn.utils.validation import check_is_fitted

from silpose.core.parameters import POSITIVE_INTEGER, SEED, Constraints, check_parameters
from silpose.core.random_states import RandomState, seed_of
from silpose.core.types import Array, Array32
from silpose.descriptor.boundary import Masks, as_mask, stack_of

_TINY = 1e-30  # keeps the logarithm of a vanishing moment finite


class HuMoments(TransformerMixin, BaseEstimator):
    """Logarithms of Hu's seven invariant moments, standardised to zero mean and unit variance.

    Attributes
    ----------
    mean_, scale_ : ndarray, shape (7,)
        Mean and standard deviation over the training masks.

    References
    ----------
    M.-K. Hu, "Visual pattern recognition by moment invariants", IRE Transactions on Information
    Theory 1962.
    """

    def fit(self, masks: Masks, y: object = None) -> HuMoments:
        """Learn mean and scale of the moments.

        Parameters
        ----------
        masks : array-like, shape (n, H, W), or list of arrays of any shapes (H, W)
        y : object, optional
            Ignored.

        Returns
        -------
        self : HuMoments
        """
        moments = _log_moments(masks)
        self.mean_ = moments.mean(axis=0)
        deviation = moments.std(axis=0)
        self.scale_ = np.where(deviation > 0, deviation, 1.0)
        return self

    def transform(self, masks: Masks) -> Array:
        """Describe masks, shape (n, 7)."""
        check_is_fitted(self)
        return (_log_moments(masks) - self.mean_) / self.scale_


class AlignedMask(TransformerMixin, BaseEstimator):
    """Principal components of the mask, scaled to one height and centred on its centroid.

    Parameters
    ----------
    size : int, default=48
        Height and width of the aligned mask, pixels.
    components : int, default=100
        Number of components, if there are as many masks and pixels.
    random_state : int, RandomState, Generator or None, default=0

    Attributes
    ----------
    pca_ : PCA
    """

    constraints: ClassVar[Constraints] = {
        "size": POSITIVE_INTEGER,
        "components": POSITIVE_INTEGER,
        "random_state": SEED,
    }

    def __init__(
        self, *, size: int = 48, components: int = 100, random_state: RandomState = 0
    ) -> None:
        self.size = size
        self.components = components
        self.random_state = random_state

    def fit(self, masks: Masks, y: object = None) -> AlignedMask:
        """Learn the components.

        Parameters
        ----------
        masks : array-like, shape (n, H, W), or list of arrays of any shapes (H, W)
        y : object, optional
            Ignored.

        Returns
        -------
        self : AlignedMask

        Raises
        ------
        InputError
            If a parameter or a mask cannot be used.
        """
        check_parameters(self)
        aligned = self._aligned(masks)
        count = min(self.components, *aligned.shape)
        self.pca_ = PCA(count, svd_solver="randomized", random_state=seed_of(self.random_state))
        self.pca_.fit(aligned)
        return self

    def transform(self, masks: Masks) -> Array:
        """Describe masks, shape (n, components)."""
        check_is_fitted(self)
        return np.asarray(self.pca_.transform(self._aligned(masks)), dtype=float)

    def _aligned(self, masks: Masks) -> Array32:
        return np.stack([self._align(as_mask(mask, k)) for k, mask in enumerate(stack_of(masks))])

    def _align(self, mask: NDArray[np.uint8]) -> Array32:
        _, top, _, height = cv2.boundingRect(mask)
        moments = cv2.moments(mask, binaryImage=True)
        scale = self.size / height
        middle = (self.size - 1) / 2
        shift = np.array(
            [[scale, 0, middle - scale * moments["m10"] / moments["m00"]], [0, scale, -scale * top]]
        )
        grey = cv2.warpAffine(mask.astype(np.float32), shift, (self.size, self.size))
        return np.asarray(grey, np.float32).ravel()


def _log_moments(masks: Masks) -> Array:
    moments = np.stack(
        [
            cv2.HuMoments(cv2.moments(as_mask(mask, k), binaryImage=True)).ravel()
            for k, mask in enumerate(stack_of(masks))
        ]
    )
    return np.sign(moments) * np.log10(np.abs(moments) + _TINY)

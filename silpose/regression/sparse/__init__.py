"""Sparse regression: the relevance vector machine by quadratic bridges, and backward elimination.

Takes normal equations of basis functions, and returns which of them are kept, and their
coefficients.
"""

from silpose.regression.sparse.bridge_path import BridgePath, follow_bridges
from silpose.regression.sparse.elimination import eliminate, sparsest_within
from silpose.regression.sparse.first_bridges import FirstBridges
from silpose.regression.sparse.quadratic_bridges import Bridges, minimise_with_bridges
from silpose.regression.sparse.rvm import RelevanceVectorRegressor

__all__ = [
    "BridgePath",
    "Bridges",
    "FirstBridges",
    "RelevanceVectorRegressor",
    "eliminate",
    "follow_bridges",
    "minimise_with_bridges",
    "sparsest_within",
]

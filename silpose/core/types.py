"""Types that every package shares."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Array32 = NDArray[np.float32]
Indices = NDArray[np.intp]
Mask = NDArray[np.uint8]
"""Shape (H, W), of 0 and 1."""

Examples = Sequence[tuple[Array, Array]]
"""Descriptors z (F, d) and poses x (F, D) of each take."""

Settings = dict[str, object]
"""Values by the name of a parameter."""

Row = dict[str, Any]
"""A line of ``results.csv``."""

Metrics = dict[str, dict[str, float]]
"""Values by method, then by name."""

"""Two walks to learn from, and a held-out one."""

import pytest

from silpose.core.pose_space import ANGLES
from silpose.tracking import TrackerSelection


@pytest.fixture
def selection(takes):
    return TrackerSelection(takes[:2], takes[2:], ANGLES, 15.0)

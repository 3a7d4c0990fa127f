import numpy as np
import pytest

from silpose.silhouette.person import PersonSelector
from silpose.silhouette.video import MaskedFrame


@pytest.mark.parametrize(
    ("flags", "state"),
    [((), "person"), (("switched",), "switched"), (("moved", "switched"), "moved")],
)
def test_the_state_is_the_gravest(truth, flags, state):
    mask, facts = PersonSelector().step(truth[5])
    frame = MaskedFrame(0, 0.0, None, mask, facts, **dict.fromkeys(flags, True))
    assert frame.state == state
    assert frame.seen


def test_a_blank_mask_has_no_person():
    mask, facts = PersonSelector().step(np.zeros((10, 10), np.uint8))
    assert MaskedFrame(0, 0.0, None, mask, facts).state == "blank"

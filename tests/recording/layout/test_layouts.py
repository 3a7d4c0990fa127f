"""Every kind of recording in the viewer."""

import cv2
import numpy as np
import pytest

from silpose.recording.viewer.screenshots import opened

VIEWS = {
    "single_image": 11,
    "prediction": 10,
    "study": 4,
    "motion": 5,
    "bridges": 6,
    "features": 4,
    "extinction": 6,
    "context_space": 6,
    "tracking": 8,
    "modes": 7,
    "hypotheses": 9,
    "fitting": 10,
    "video": 10,
}


@pytest.mark.parametrize("kind", VIEWS)
def test_it_opens_without_an_error(recordings, kind, drawing):
    with opened(recordings[kind]) as viewer:
        viewer.set_time("frame", sequence=1, play_state="paused")
        picture = viewer.take_screenshot(max_size=1600)
        views = viewer.get_state().views
    assert {view.name: [r.summary for r in view.reports] for view in views if view.reports} == {}
    assert len(views) == VIEWS[kind]
    seen = cv2.imdecode(np.frombuffer(picture, np.uint8), cv2.IMREAD_COLOR)
    assert seen.std() > 10  # something is drawn


def test_there_is_a_layout_for_every_kind(recordings):
    assert set(VIEWS) == set(recordings)

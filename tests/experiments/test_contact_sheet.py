import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette import BODIES, LEVELS


@pytest.fixture(scope="module")
def sheet(run, walkers):
    return run("contact_sheet", walkers, cameras=3, bodies=2, strengths=[0.5, 1])


def test_there_is_a_row_for_every_body_and_a_column_for_every_camera(sheet):
    axes = sheet.result.figure.axes
    bodies = len(LEVELS) + len(BODIES) - 1 + 2
    assert len(axes) == 3 * (bodies + 2)
    titles = [a.get_ylabel() for a in axes[::3]]
    assert titles[-2:] == ["degraded by 0.5", "degraded by 1"]
    assert sum(title.startswith("shape of length") for title in titles) == 2
    assert all("°" in a.get_title() for a in axes[:3])
    assert sheet.metrics == {} and sheet.rows == []


def test_every_cell_shows_a_person_and_degradation_grows(sheet):
    masks = [1 - a.images[0].get_array() for a in sheet.result.figure.axes]
    assert all(np.any(mask) for mask in masks)
    rows = np.reshape(masks, (-1, 3, 96, 96))
    first, weak, strong = rows[0], rows[-2], rows[-1]
    changed = [np.mean(first != degraded) for degraded in (weak, strong)]
    assert 0 < changed[0] < changed[1]


def test_counts_must_be_positive_and_motion_rendered(run, walkers, authors):
    with pytest.raises(InputError, match="cameras must be a positive integer, not 0"):
        run("contact_sheet", walkers, cameras=0)
    with pytest.raises(InputError, match="contact_sheet renders motion"):
        run("contact_sheet", authors)

import pytest

from silpose.core.errors import InputError
from silpose.regression import Candidates
from silpose.tracking import (
    BeliefTracker,
    SecondOrderDynamics,
    SmoothingBaselines,
    TrackingCandidates,
)
from silpose.tracking.selection.candidates import settings_to_choose


def candidates(**grid):
    return Candidates(BeliefTracker(pose_width=0.7), grid)


def test_settings_have_what_is_always_there_and_what_else_is_in_the_grid():
    found = settings_to_choose(
        "tracker", candidates(restart=[0.0, 1e-6], damping=[1, 4]), "pose_width", "damping",
        also=("restart",),
    )  # fmt: skip
    assert found == [
        {"pose_width": 0.7, "damping": damping, "restart": restart}
        for damping in (1, 4)
        for restart in (0.0, 1e-6)
    ]


def test_without_anything_to_choose_there_is_one_empty_setting():
    assert settings_to_choose("tracker", candidates()) == [{}]


def test_a_grid_that_nobody_searches_is_refused():
    with pytest.raises(InputError, match=r"tracking\.tracker\.keep is not chosen .* \[0.1, 0.2\]"):
        settings_to_choose("tracker", candidates(keep=[0.1, 0.2]), "pose_width")


@pytest.mark.parametrize(
    ("make", "match"),
    [
        (lambda: candidates(pose_width=[]), "pose_width must be a list of one value or more"),
        (lambda: candidates(damping=[1, 0]), "damping must be positive, not 0"),
        (lambda: candidates(body_alone=[2]), "body_alone must be from 0 to 1 or None, not 2"),
        (lambda: TrackingCandidates(lag=-1), "lag must be zero or positive, not -1"),
        (lambda: Candidates(SecondOrderDynamics(damping=0)), "damping must be positive"),
        (lambda: SmoothingBaselines(window=[-3]), "window must be a positive integer, not -3"),
        (lambda: SmoothingBaselines(fusion=[]), "fusion must be at least one value"),
    ],
)
def test_wrong_settings_are_named(make, match):
    with pytest.raises(InputError, match=match):
        make()


def test_candidates_that_are_not_given_are_the_defaults():
    default = TrackingCandidates()
    assert default.tracker.estimator.get_params() == BeliefTracker().get_params()
    assert all(not getattr(default, name).grid for name in ("tracker", "dynamics", "hypotheses"))

import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.regression import Basis, RidgeRegressor
from silpose.tracking import (
    DynamicsSettings,
    JointSettings,
    RivalSettings,
    Selection,
    TrackerSettings,
    choose_dynamics,
    choose_joint,
    choose_rivals,
    choose_tracker,
)


@pytest.fixture
def selection(takes):
    return Selection(takes[:2], takes[2:], ANGLES, 15.0)


def test_the_setting_best_on_validation_wins(selection):
    tried = {"pose_width": [0.3, 0.7], "descriptor_width": [0.6, 1, 1.6], "damping": [1, 4]}
    settings = TrackerSettings(keep=0.3, heading_alone=0.0, body_alone=0.0, **tried)
    chosen = choose_tracker(selection, settings)
    best = min(selection.rows, key=lambda row: row["validation_error"])
    assert [getattr(chosen, name) for name in tried] == [best[name] for name in tried]
    assert len(selection.rows) == 12
    (z, x), *_ = selection.validation
    error = ANGLES.distance(x, chosen.track(z).x).mean()
    assert error == pytest.approx(best["validation_error"])


def test_without_validation_sequences_take_turns(takes):
    turns = Selection(takes, [], ANGLES, 15.0)
    chosen = choose_dynamics(turns, DynamicsSettings(damping=[1.0, 1e6]))
    assert chosen.damping == 1.0
    with pytest.raises(InputError, match="two for training"):
        choose_dynamics(Selection(takes[:1], [], ANGLES, 15.0), DynamicsSettings())


def test_a_hopeless_sequence_does_not_decide(takes):
    def family(learnt):
        hopeless = len(learnt[0][0]) != len(takes[0][0]) or learnt[0] is not takes[0]
        # 2 % better on the sequence that fails anyhow, 20 % worse on the others.
        return lambda choice: lambda z, _: np.full((len(z), 55), errors[hopeless][choice])

    errors = {True: {0: 50.0, 1: 49.0}, False: {0: 1.0, 1: 1.2}}
    flat = [(z, np.zeros_like(x)) for z, x in takes]
    takes = flat
    chosen = Selection(flat, [], ANGLES, 15.0).best("any", {"choice": [0, 1]}, family)
    assert chosen == {"choice": 0}


def test_of_many_sequences_every_few_judge():
    sequences = [(np.full((50, 1), k), np.zeros((50, 55))) for k in range(80)]
    judges = []

    def family(learnt):
        return lambda choice: lambda z, start: judges.append(z[0, 0]) or np.zeros((len(z), 55))

    Selection(sequences[:40], sequences[40:], ANGLES, 15.0).best("any", {"choice": [0, 1]}, family)
    assert sorted(set(judges)) == list(range(40, 80, 3))


def test_every_rival_gives_poses(selection, unseen):
    dynamics = choose_dynamics(selection, DynamicsSettings())
    z, x = (np.concatenate(part) for part in zip(*selection.train, strict=True))
    ridge = RidgeRegressor(Basis(width=2, hellinger=True)).fit(z, x)
    settings = RivalSettings(smoothing=[5, 9], window=[3], neighbours=[20], viterbi_weight=[3, 9])
    rivals = choose_rivals(selection, settings, ridge, dynamics)
    assert set(rivals) == {"smoothed", "fused", "windowed", "nearest_smoothed", "nearest_viterbi"}
    for estimate in rivals.values():
        assert estimate(unseen[0], unseen[1][:2]).shape == unseen[1].shape


def test_the_papers_tracker_keeps_as_few_kernels_as_asked_for(selection, unseen):
    dynamics = choose_dynamics(selection, DynamicsSettings())
    settings = JointSettings(pose_width=1.0, descriptor_width=2.0, centres=200)
    joint = choose_joint(selection, settings, dynamics)
    assert joint.regressor.kept_ == pytest.approx(0.18)
    assert joint.track(unseen[0], unseen[1][:2])[0].shape == unseen[1].shape


@pytest.mark.parametrize(
    ("settings", "match"),
    [
        (lambda: TrackerSettings(pose_width=[]), "tracking.tracker.pose_width"),
        (lambda: TrackerSettings(damping=0), "tracking.tracker.damping"),
        (lambda: TrackerSettings(lag=-1), "tracking.tracker.lag"),
        (lambda: TrackerSettings(body_alone=2), "tracking.tracker.body_alone"),
        (lambda: DynamicsSettings(damping=0), "tracking.dynamics.damping"),
        (lambda: RivalSettings(window=[-3]), "tracking.rivals.window"),
    ],
)
def test_wrong_settings_are_named(settings, match):
    with pytest.raises(InputError, match=match):
        settings()

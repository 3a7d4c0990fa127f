from functools import partial

import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.tracking.takes import TrainingTakes, checked_poses, checked_takes

Z, X = np.full((6, 4), 0.25), np.arange(30.0).reshape(6, 5)


def read(take):
    return take


def test_blocks_are_all_frames_in_order_whatever_the_takes():
    takes = TrainingTakes([(Z, X), (Z[:0], X[:0]), (Z[:1], X[:1] + 40), (Z, X + 50)])
    whole = np.concatenate([X, X[:1] + 40, X + 50])
    for most in (1, 4, 13, 100):
        blocks = list(takes.blocks(most))
        assert {len(block.x) for block in blocks[:-1]} <= {most}
        assert np.array_equal(np.concatenate([block.x for block in blocks]), whole)
        assert sum(len(block.z) for block in blocks) == 13


def test_after_the_last_pose_of_a_take_velocity_stays():
    following = np.concatenate([b.following for b in TrainingTakes([(Z, X), (Z, X)]).blocks(5)])
    assert np.array_equal(following, np.concatenate([X + 5, X + 5]))
    (alone,) = TrainingTakes([(Z[:1], X[:1])]).blocks()
    assert np.array_equal(alone.following, X[:1])


def test_functions_are_called_in_every_pass_and_not_kept():
    calls = []

    def take():
        calls.append(None)
        return Z.tolist(), X.tolist()

    takes = TrainingTakes([take, (Z, X)])
    assert not takes.in_memory
    assert TrainingTakes.of(takes) is takes
    before = len(calls)
    assert [len(x) for _, x in takes] == takes.lengths == [6, 6]
    assert np.array_equal(takes.poses[0], X)
    assert checked_poses(takes.poses)[1] is X
    assert len(calls) == before + 2


def test_a_function_is_checked_as_a_pair_is():
    with pytest.raises(InputError, match="poses of take 1 are not finite in frame 2"):
        TrainingTakes([(Z, X), partial(read, (Z, np.where(X == 10, np.nan, X)))])
    with pytest.raises(InputError, match="take 0 is no pair"):
        TrainingTakes([partial(read, 3)])
    ((z, x),) = checked_takes([partial(read, (Z, X))])
    assert z.shape == (6, 4)
    assert x.shape == (6, 5)

import inspect

import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.motion import WalkerTakes


@pytest.fixture(scope="module")
def takes():
    return WalkerTakes().takes()


def test_names_frames_and_performers(takes):
    names = [take.name for take in takes]
    assert len(set(names)) == 10 and names[8:] == ["validation", "test"]
    assert all(name.startswith(f"train_{k}_") for k, name in enumerate(names[:8], start=1))
    assert [take.performer for take in takes] == [f"walker_{k}" for k in range(1, 11)]
    assert 1900 < sum(map(len, takes[:8])) < 2200
    for take in takes[8:]:
        assert 390 < len(take) < 440
    for take in takes:
        assert take.angles.shape == (len(take), 54) and take.root_position.shape == (len(take), 3)
        assert np.isfinite(take.angles).all() and take.frames_per_second == 15.0


def test_headings_are_covered_evenly(takes):
    counts, _ = np.histogram(
        np.concatenate([take.angles[:, 0] for take in takes[:8]]), 24, (-180, 180)
    )
    assert counts.min() > 0.6 * counts.mean() and counts.max() < 1.5 * counts.mean()
    for take in takes[8:]:
        turned = np.unwrap(take.angles[:, 0], period=360)
        assert 2.5 * 360 < abs(turned[-1] - turned[0]) < 3.2 * 360
        assert np.histogram(take.angles[:, 0], 36, (-180, 180))[0].min() > 0


def test_deterministic_by_seed(takes):
    again, other = WalkerTakes(seed=0).takes(), WalkerTakes(seed=1).takes()
    for one, two, three in zip(takes, again, other, strict=True):
        np.testing.assert_array_equal(one.angles, two.angles)
        np.testing.assert_array_equal(one.root_position, two.root_position)
        assert np.abs(one.angles - three.angles).max() > 5


def test_every_take_has_another_walker(takes):
    means = np.array([take.angles[:, 1:].mean(axis=0) for take in takes])
    for k in range(len(means)):
        others = np.delete(means, k, axis=0)
        assert np.abs(others - means[k]).max(axis=1).min() > 3


def test_small_and_short():
    takes = WalkerTakes(seconds=1.0, test_seconds=1.0, frames_per_second=8.0).takes()
    assert [len(take) for take in takes] == [8] * 10


def test_spread():
    alike, mixed = (
        np.array([t.angles[:, 1:].mean(axis=0) for t in WalkerTakes(spread=s).takes()])
        for s in (0.0, 1.0)
    )
    assert 3 * alike.std(axis=0).mean() < mixed.std(axis=0).mean()
    with pytest.raises(InputError, match=r"motion\.spread"):
        WalkerTakes(spread=-1.0)


def test_settings_are_plain_numbers():
    for parameter in inspect.signature(WalkerTakes).parameters.values():
        assert isinstance(parameter.default, (int, float))


@pytest.mark.parametrize(
    "name", ["seconds", "test_seconds", "frames_per_second", "turns", "test_turns", "radius_ratio"]
)
@pytest.mark.parametrize("value", [0.0, -1.0, float("nan"), float("inf")])
def test_bad_settings_are_named(name, value):
    with pytest.raises(InputError, match=f"motion.{name} "):
        WalkerTakes(**{name: value})

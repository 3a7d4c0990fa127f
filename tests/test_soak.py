"""A live stream, from masks to fitted poses, that is fed anything for long.

``pytest -m long tests/test_soak.py`` feeds an hour's worth of frames.
"""

import sys

import numpy as np
import pytest
from small_model import tracking_and_fitting

from silpose.core.errors import InputError

pytestmark = pytest.mark.filterwarnings("ignore")
HOUR = 54_000  # frames, of 15 a second
GROWTH = 5_000  # kilobytes that the process may have taken more at its end than after a fifth
RECOVERY = 8  # good frames after which the person is seen again


@pytest.fixture(scope="module")
def model(sequence, body, camera):
    return tracking_and_fitting(sequence, body, camera)


def odd_frames(masks, rng):
    """Frames that are no person, or no mask at all, each with its name."""
    mask = masks[rng.integers(len(masks))]
    specks = (rng.random(mask.shape) < rng.random()).astype(np.uint8)
    cut = mask.copy()
    cut[: rng.integers(len(mask))] = 0
    return {
        "blank": 0 * mask,
        "full": 1 + 0 * mask,
        "specks": specks,
        "part": cut,
        "inverted": 1 - mask,
        "one pixel": (np.arange(mask.size) == rng.integers(mask.size)).reshape(mask.shape),
        "larger": np.kron(mask, np.ones((2, 2), np.uint8)),
        "smaller": mask[::3, ::3],
        "a strip": mask[:1],
        "no pixels": mask[:0],
        "NaN": np.where(mask, np.nan, 0.0),
        "infinite": np.where(mask, np.inf, 0.0),
        "huge": mask * 1e300,
        "numbers": rng.normal(size=mask.shape),
        "words": np.full(mask.shape, "a"),
        "four axes": mask[None, None],
        "nothing": None,
    }


def feed(stream, masks, frames, rng):
    """Feed mostly a walk, and now and then something odd; return the states of good frames."""
    states, k = [], 0
    while k < frames:
        names = sorted(odd_frames(masks, rng))
        for _ in range(rng.integers(1, 5)):
            name = str(rng.choice(names))
            try:
                poses = stream.step(odd_frames(masks, rng)[name])
            except InputError as error:
                assert "\n" not in str(error) and len(str(error)) < 400
                continue
            assert np.isfinite(poses.x).all(), name
            assert 0 <= poses.confidence[0] <= 1
        for _ in range(RECOVERY):
            poses = stream.step(masks[k % len(masks)])
            assert np.isfinite(poses.x).all()
            k += 1
        states.append(poses.state[0])
    return states


def most_memory():
    """Kilobytes that the process has ever held, those of compiled libraries among them."""
    resource = pytest.importorskip("resource")
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // (
        1024 if sys.platform == "darwin" else 1
    )


@pytest.mark.parametrize("frames", [80, pytest.param(HOUR, marks=pytest.mark.long)])
def test_a_stream_recovers_from_anything_and_does_not_grow(model, sequence, frames):
    rng = np.random.default_rng(0)
    stream = model.stream(fit=True)
    stream.step(sequence.masks[0])  # says how large masks are
    states = feed(stream, sequence.masks, frames // 5, rng)
    before = most_memory()
    states += feed(stream, sequence.masks, frames - frames // 5, rng)
    if frames == HOUR:  # what is made once is there after a fifth of them
        assert most_memory() - before < GROWTH
    assert set(states) == {"tracking"}

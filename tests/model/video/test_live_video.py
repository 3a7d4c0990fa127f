import signal
import time
import tracemalloc

import numpy as np
import pytest

from silpose.model.video import live_steps
from silpose.silhouette.person import PersonSelector
from silpose.silhouette.video import MaskedFrame


def frames_of(masks, count, every=1, interval=0.0):
    """Frames of a camera that drops all but some of them."""
    selector = PersonSelector(None)
    for k in range(0, count, every):
        time.sleep(interval)
        mask = masks[k % len(masks)]
        picture = np.zeros((*mask.shape, 3), np.uint8)
        yield MaskedFrame(k, k / 15, picture, *selector.step(mask))


def test_steps_have_what_a_camera_gives_them(model, sequence):
    steps = list(live_steps(model, frames_of(sequence.masks, 7, every=3)))
    assert [step.index for step in steps] == [0, 3, 6]
    assert [step.dropped for step in steps] == [0, 2, 2]
    assert all(0 < step.latency < 5 for step in steps)
    assert all(np.isfinite(step.skeleton).all() and len(step.outline) > 9 for step in steps)
    assert [step.poses.time[0] for step in steps] == pytest.approx([0, 0.2, 0.4])


def test_ctrl_c_ends_after_the_step_under_way(model, sequence):
    before = signal.getsignal(signal.SIGINT)
    steps = []
    for step in live_steps(model, frames_of(sequence.masks, 40)):
        steps.append(step)
        if len(steps) == 3:
            signal.raise_signal(signal.SIGINT)
    assert len(steps) == 3
    assert signal.getsignal(signal.SIGINT) is before


def test_ctrl_c_ends_a_camera_that_gives_nothing(model, sequence):
    def stalling(after):
        yield from frames_of(sequence.masks, after)
        signal.raise_signal(signal.SIGINT)
        raise AssertionError("it went on")

    assert len(list(live_steps(model, stalling(2)))) == 2
    with pytest.raises(KeyboardInterrupt):  # there is nothing to complete
        list(live_steps(model, stalling(0)))


def test_a_second_ctrl_c_interrupts(model, sequence):
    before = signal.getsignal(signal.SIGINT)
    steps = live_steps(model, frames_of(sequence.masks, 40))
    next(steps)
    signal.raise_signal(signal.SIGINT)
    with pytest.raises(KeyboardInterrupt):
        signal.raise_signal(signal.SIGINT)
    steps.close()
    assert signal.getsignal(signal.SIGINT) is before


def test_steps_are_not_held(model, sequence):
    steps = live_steps(model, frames_of(sequence.masks, 10_000))
    for _ in range(5):
        next(steps)
    tracemalloc.start()
    try:
        for _ in range(20):
            next(steps)
        first = tracemalloc.get_traced_memory()[0]
        for _ in range(20):
            next(steps)
        assert tracemalloc.get_traced_memory()[0] - first < 200_000  # less than three pictures
    finally:
        tracemalloc.stop()
        steps.close()

import threading
import time

import numpy as np
import pytest

from silpose.silhouette.video.frame import Frame
from silpose.silhouette.video.threaded import Threaded, in_real_time

PICTURE = np.zeros((4, 4, 3), np.uint8)


def frames(count, made=None, interval=0.0):
    for index in range(count):
        if made is not None:
            made.append(index)
        time.sleep(interval)
        yield Frame(index, 0.02 * index, PICTURE)


def decoders():
    return [thread for thread in threading.enumerate() if thread.name == "decoder"]


def test_frames_come_in_order_and_the_thread_ends():
    assert [frame.index for frame in Threaded(frames(50))] == list(range(50))
    assert not decoders()


def test_no_more_than_a_few_frames_are_decoded_ahead():
    made = []
    running = iter(Threaded(frames(1000, made)))
    next(running)
    time.sleep(0.1)
    assert len(made) < 15
    running.close()
    assert not decoders()


def test_an_error_of_the_decoder_is_the_readers():
    def failing():
        yield Frame(0, 0.0, PICTURE)
        raise OSError("gone")

    seen = []
    with pytest.raises(OSError, match="gone"):
        seen.extend(Threaded(failing()))
    assert not decoders()


def test_a_live_source_drops_frames_rather_than_falls_behind():
    live = Threaded(in_real_time(frames(60)), drop=True)
    start, late, seen = time.monotonic(), [], []
    for frame in live:
        late.append(time.monotonic() - start - frame.time)
        seen.append(frame.index)
        time.sleep(0.07)
    assert live.dropped == 60 - len(seen) > 20
    assert seen == sorted(seen)
    assert max(late) < 0.6

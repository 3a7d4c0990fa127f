"""A camera that stalls, vanishes, comes back, and changes."""

import warnings

import cv2
import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette.video import live_frames
from silpose.silhouette.video.live_frames import LiveFrames

PICTURE = np.full((48, 64, 3), 99, np.uint8)
LARGER = np.full((96, 128, 3), 99, np.uint8)
TURNED = np.full((64, 48, 3), 99, np.uint8)


class Capture:
    """A capture that reads what it was given, with its time stamps, and then fails."""

    def __init__(self, pictures, stamps=None, rate=25.0, count=-1.0):
        self.pictures, self.stamps = list(pictures), list(stamps or [])
        self.told = {cv2.CAP_PROP_FPS: rate, cv2.CAP_PROP_FRAME_COUNT: count}
        self.stamp, self.released = 0.0, False

    def read(self):
        if not self.pictures:
            return False, None
        self.stamp = self.stamps.pop(0) if self.stamps else 0.0
        return True, self.pictures.pop(0)

    def get(self, what):
        return 1000 * self.stamp if what == cv2.CAP_PROP_POS_MSEC else self.told[what]

    def release(self):
        self.released = True


@pytest.fixture
def opening(monkeypatch):
    """Make sources that are, one after the other, these captures; None cannot be opened."""

    def of(*captures):
        waiting = list(captures)

        def open_capture(source):
            capture = waiting.pop(0) if waiting else None
            if capture is None:
                raise InputError("there is nothing")
            return capture

        monkeypatch.setattr(live_frames, "open_capture", open_capture)
        monkeypatch.setattr(live_frames, "_PAUSE", 0.02)
        return captures

    return of


def test_a_camera_that_vanishes_is_tried_again(opening):
    first, *_, again = opening(Capture([PICTURE] * 4), None, None, Capture([PICTURE] * 3))
    frames = []
    with pytest.warns(UserWarning) as said:
        frames.extend(LiveFrames(0, 960, patience=0.3))
    words = [str(warning.message) for warning in said]
    assert words[0] == "camera 0 gives no more pictures after 3: trying again for 0.3 s"
    assert words[1].startswith("camera 0 is back after 0.")
    assert words[-1] == "camera 0 did not come back: it ends here"
    gone = [frame.gone for frame in frames]
    assert gone[:9] == [False] * 3 + [True] * 3 + [False] * 3
    assert all(gone[9:])
    assert [frame.index for frame in frames] == list(range(len(frames)))
    times = np.diff([frame.time for frame in frames])
    assert (times > 0).all()
    assert times[2:5] == pytest.approx([0.02] * 3, abs=0.3)
    assert first.released
    assert again.released


def test_a_stream_has_its_own_clock_until_that_jumps(opening):
    stamps = [5.0, 5.1, 5.2, 5.6, 90.0, 90.1, 3.0, 3.1]  # the first picture shows that there is one
    opening(Capture([PICTURE] * 8, stamps, rate=10.0, count=7))
    frames = list(LiveFrames("rtsp://door", 960))
    times = [frame.time for frame in frames]
    assert times == pytest.approx([0, 0.1, 0.5, 0.6, 0.7, 0.8, 0.9])


def test_another_resolution_is_scaled_and_another_shape_the_end(opening):
    opening(Capture([PICTURE, PICTURE, LARGER, PICTURE, TURNED, PICTURE]))
    seen = []
    with pytest.warns(UserWarning, match="are 48x64 from frame 3 on, and were 64x48: it ends here"):
        seen.extend(LiveFrames(0, 960))
    assert [frame.picture.shape for frame in seen] == [(48, 64, 3)] * 3


def test_a_film_that_is_streamed_ends_at_its_end(opening):
    opening(Capture([PICTURE] * 10, count=10.0))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert len(list(LiveFrames("http://films/walk.mp4", 960))) == 9


def test_what_gives_no_pictures_is_refused_and_a_camera_is_read_once(opening):
    opening(Capture([]), Capture([PICTURE] * 3, count=3.0))
    with pytest.raises(InputError, match="camera 0 gives no pictures"):
        LiveFrames(0, 960)
    frames = LiveFrames("http://films/walk.mp4", 960)
    assert list(frames.sample(9)) == []
    assert len(list(frames)) == 2
    with pytest.raises(InputError, match="was read already"):
        list(frames)

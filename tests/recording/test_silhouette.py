import numpy as np

from silpose.recording.silhouette import window_of


def test_a_window_holds_the_person_of_every_frame():
    masks = np.zeros((3, 100, 100), np.uint8)
    masks[0, 20:70, 40:50] = 1
    masks[1, 30:80, 60:70] = 1  # the third is blank
    assert window_of(masks) == (40 - 4, 70 + 4, 20 - 4, 80 + 4)
    assert window_of(masks[2:]) is None and window_of(()) is None

import cv2
import numpy as np

from silpose.silhouette.masks.opencv_log import silent_opencv


def test_nothing_is_printed_and_the_level_is_put_back(capfd):
    level = cv2.utils.logging.getLogLevel()
    with silent_opencv():
        assert cv2.imdecode(np.frombuffer(b"II*\0broken", np.uint8), -1) is None
    assert capfd.readouterr() == ("", "")
    assert cv2.utils.logging.getLogLevel() == level

"""MediaPipe's selfie segmentation, as a program of its own: pictures come in, masks go out.

It runs in an environment that has MediaPipe 0.10.21, whose wheel carries the network and which
needs NumPy 1; so it must not import anything else. A picture is its height and width as two
integers of 32 bits, then its bytes, RGB; a mask has the same height and width, 1 for the person.
"""

import os
import sys

import numpy as np

_PERSON = 0.5  # probability from which a pixel shows a person


def main() -> None:
    """Answer each picture until there are no more."""
    taken, given = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what the library prints is no mask
    from mediapipe.python.solutions.selfie_segmentation import SelfieSegmentation

    network = SelfieSegmentation(model_selection=0)
    given.write(b"ready\n")
    given.flush()
    while len(size := taken.read(8)) == 8:
        height, width = np.frombuffer(size, "<i4").tolist()
        picture = np.frombuffer(taken.read(3 * height * width), np.uint8)
        answer = network.process(picture.reshape(height, width, 3)).segmentation_mask
        given.write((answer > _PERSON).astype(np.uint8).tobytes())
        given.flush()


if __name__ == "__main__":
    main()

import numpy as np

from silpose.silhouette.masks import MaskSequence


def test_is_the_sequence_of_its_masks():
    masks = [np.zeros((3, 4), np.uint8), np.ones((5, 4), np.uint8)]
    sequence = MaskSequence(masks, ["a", "b"], "'folder'", "grey values")
    assert len(sequence) == 2
    assert [mask.shape for mask in sequence] == [(3, 4), (5, 4)]
    assert sequence[1] is masks[1]

import numpy as np

from silpose.experiments.masks_report import SeenTake, in_columns, report, shortened
from silpose.silhouette import MaskSequence
from silpose.silhouette.person import select_person


def seen(name="", names="abc", **facts):
    mask = np.zeros((40, 30), np.uint8)
    mask[5:35, 10:20] = 1
    masks = [mask, 0 * mask, np.vstack([mask[5:], mask[:5]])]
    sequence = MaskSequence(masks, list(names), "'it'", "grey values", 25, **facts)
    shapes = np.array([mask.shape for mask in masks])
    return SeenTake(name, sequence, shapes, select_person(masks).facts)


def test_a_source_is_described_line_by_line():
    ignored = ("x.jpg: no mask", "y.jpg: no mask", "z.txt: no image")
    (facts,) = report([seen(ignored=ignored, notes=("a note",))], 15)
    told = in_columns(facts)
    lines = [line.split(maxsplit=1) for line in told.splitlines()]
    assert ["masks", "3 of 40 x 30 pixels, height x width"] in lines
    assert ["rate", "25 frames per second; 15 are used"] in lines
    assert ["blank", "1: b"] in lines
    assert "left out    2 files (no mask): x.jpg, y.jpg\nleft out    1 file (no image)" in told
    assert "decided     a note" in told
    assert "in time" not in told
    (facts,) = report([seen(names=("1.png", "2.png", "4.png"))])
    assert "in time     1 masks in 'it' are missing by the numbers" in in_columns(facts)


def test_takes_are_named():
    told = "\n".join(map(in_columns, report([seen("001"), seen("002")])))
    assert "takes       2: 001, 002" in told
    assert "blank       2: 001/b, 002/b" in told
    assert seen("001").rows()[1] | {"take": "001", "state": "blank"} == seen("001").rows()[1]


def test_long_lists_are_shortened():
    assert shortened(list("abcdefg")) == "a, b, c, d, e and 2 more"

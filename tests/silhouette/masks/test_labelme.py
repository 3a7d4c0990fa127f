import json

import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette.masks import read_masks

SQUARE = [[10, 5], [20, 5], [20, 40], [10, 40]]
OTHER = [[0, 0], [6, 0], [6, 6]]


def shape(label, points, kind="polygon"):
    return {"label": label, "points": points, "shape_type": kind}


def folder_of(folder, *frames):
    for k, shapes in enumerate(frames):
        content = {"shapes": shapes, "imagePath": f"{k}.jpg", "imageHeight": 48, "imageWidth": 40}
        (folder / f"{k}.json").write_text(json.dumps(content))
    return folder


def test_frames_without_the_person_are_blank(tmp_path):
    person, dog = shape("person", SQUARE), shape("dog", OTHER)
    read = read_masks(folder_of(tmp_path, [], [person, dog], [dog], [person]))
    assert [bool(mask.any()) for mask in read] == [False, True, False, True]
    assert read.names[2] == "2.json"
    np.testing.assert_array_equal(read[1], read[3])


def test_boxes_are_refused(tmp_path):
    box = shape("person", [[10, 5], [20, 40]], "rectangle")
    with pytest.raises(InputError, match="of the kind rectangle, and no polygons: outline"):
        read_masks(folder_of(tmp_path, [box], []))
    with pytest.raises(InputError, match="of the kind rectangle, and no polygons: outline"):
        read_masks(folder_of(tmp_path, [box]) / "0.json")


def test_other_json_beside_is_no_labelme(tmp_path):
    folder = folder_of(tmp_path, [shape("person", SQUARE)])
    (folder / "1.json").write_text('{"size": [4, 4], "counts": [4, 12]}')
    assert len(read_masks(folder)) == 2

import json

import numpy as np
import pytest
from mask_encodings import run_lengths_of

from silpose.core.errors import InputError
from silpose.silhouette.masks import MaskSource, read_masks
from silpose.silhouette.masks.coco import pictures_of_records


def runs(mask):
    return {"size": list(mask.shape), "counts": run_lengths_of(mask)}


def annotations(figures, **others):
    return [{"image_id": k, "segmentation": runs(m), **others} for k, m in enumerate(figures)]


def read(tmp_path, content, **options):
    (tmp_path / "masks.json").write_text(json.dumps(content))
    return read_masks(tmp_path / "masks.json", MaskSource(**options))


def test_every_form_of_json_gives_the_same_masks(tmp_path, figures):
    images = [
        {"id": k, "file_name": f"{k}.jpg", "height": 48, "width": 40} for k in range(len(figures))
    ]
    for content in (
        annotations(figures),  # results
        {"annotations": annotations(figures)},
        {"images": images, "annotations": annotations(figures)[::-1]},
        [runs(mask) for mask in figures],
        [{"segmentation": mask.tolist(), "image_id": k} for k, mask in enumerate(figures)],
    ):
        np.testing.assert_array_equal(read(tmp_path, content).masks, figures)
        np.testing.assert_array_equal(read_masks(content).masks, figures)


def test_images_without_annotation_are_blank_and_in_the_order_of_their_names(tmp_path, figures):
    images = [
        {"id": key, "file_name": f"frame{n}.jpg", "height": 48, "width": 40}
        for key, n in ((7, 10), (8, 2), (9, 1))
    ]
    content = {"images": images, "annotations": [{"image_id": 7, "segmentation": runs(figures[0])}]}
    sequence = read(tmp_path, content)
    assert sequence.names == ["frame1.jpg", "frame2.jpg", "frame10.jpg"]
    assert [mask.any() for mask in sequence] == [False, False, True]
    assert [mask.any() for mask in read_masks([None, runs(figures[0])])] == [False, True]


def test_only_people_are_taken_if_there_are_categories(tmp_path, figures):
    dog = np.ones_like(figures[0])
    content = {
        "categories": [{"id": 1, "name": "person"}, {"id": 18, "name": "dog"}],
        "annotations": [
            {"image_id": 1, "category_id": 1, "segmentation": runs(figures[0])},
            {"image_id": 1, "category_id": 18, "segmentation": runs(dog)},
        ],
    }
    np.testing.assert_array_equal(read(tmp_path, content)[0], figures[0])


def test_identities_are_labels(tmp_path, figures):
    left, right = figures[0], np.roll(figures[0], 12, axis=1)
    right[left > 0] = 0
    content = [
        {"image_id": 0, "track_id": 4, "segmentation": runs(left)},
        {"image_id": 0, "track_id": 9, "segmentation": runs(right)},
    ]
    with pytest.raises(InputError, match=r"2 labels, 4 .*, 9 .*silhouette\.label=4"):
        read(tmp_path, content)
    np.testing.assert_array_equal(read(tmp_path, content, label=9)[0], right)


def test_polygons_are_filled_up_to_the_pixels_corners(tmp_path):
    polygon = [[4.0, 3.0, 11.0, 3.0, 11.0, 9.0, 4.0, 9.0]]
    content = {
        "images": [{"id": 1, "height": 20, "width": 30}],
        "annotations": [{"image_id": 1, "segmentation": polygon}],
    }
    mask = read(tmp_path, content)[0]
    expected = np.zeros((20, 30), np.uint8)
    expected[3:9, 4:11] = 1
    assert (mask != expected).sum() <= expected.sum() // 3  # its outline may belong to it
    assert mask[4:8, 5:10].all() and not mask[:2].any() and not mask[:, :3].any()
    with pytest.raises(InputError, match="is a polygon, and its image has no height and width"):
        read(tmp_path, {"annotations": content["annotations"]})


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "incomplete, or no JSON"),
        ('{"annotations": [', "incomplete, or no JSON"),
        ("[]", "holds no masks"),
        ("3", "holds no masks"),
        ('{"images": []}', "holds no masks"),
        ("[1, 2]", "item 0 .* is no mask"),
        ('[{"keypoints": [1]}]', "holds joints of bodies, and no masks"),
        (
            '{"annotations":[{"image_id":1,"segmentation":{"size":[9,9],"counts":"abc"}}]}',
            "image 1",
        ),
    ],
)
def test_json_without_masks_is_named(tmp_path, text, message):
    (tmp_path / "masks.json").write_text(text)
    with pytest.raises(InputError, match=rf"{message}"):
        read_masks(tmp_path / "masks.json")


def test_masks_of_one_image_have_one_size(tmp_path, figures):
    masks = (figures[0], figures[0][:, :-1])
    with pytest.raises(InputError, match="has masks of several sizes"):
        read(tmp_path, [{"image_id": 1, "segmentation": runs(mask)} for mask in masks])


def test_identities_must_be_numbers(tmp_path, figures):
    with pytest.raises(InputError, match="the identity 'bob': give each person a number"):
        read(tmp_path, [{"image_id": 0, "track_id": "bob", "segmentation": runs(figures[0])}])


def test_images_alone_are_blank_or_refused(tmp_path):
    images = [{"id": 1, "height": 4, "width": 5}]
    nothing = [{"image_id": 1, "segmentation": None}]
    blank = read(tmp_path, {"images": images, "annotations": nothing})
    assert blank[0].shape == (4, 5) and not blank[0].any()
    with pytest.raises(InputError, match="no image has a height and width"):
        read(tmp_path, {"annotations": nothing})


def test_polygons_of_labelme_are_people_of_that_name(tmp_path):
    square = [[10, 5], [20, 5], [20, 40], [10, 40]]
    other = [[0, 0], [5, 0], [5, 5]]
    shapes = [
        {"label": label, "points": points, "shape_type": "polygon"}
        for label, points in (("person", square), ("bag", other))
    ]
    content = {"shapes": shapes, "imagePath": "a.jpg", "imageHeight": 48, "imageWidth": 40}
    expected = np.zeros((48, 40), np.uint8)
    expected[5:40, 10:20] = 1
    sequence = read(tmp_path, content)
    assert sequence.names == ["a.jpg"]
    assert (sequence.masks[0] != expected).mean() < 0.03
    assert not sequence.masks[0][:5, :5].any()


def test_masks_by_frame_and_object_may_be_arrays(figures):
    by_object = {k: {1: mask[None] > 0} for k, mask in enumerate(figures)}
    by_frame = {k: mask > 0 for k, mask in enumerate(figures)}
    for content in (by_object, by_frame):
        np.testing.assert_array_equal(read_masks(content).masks, figures)


def test_a_folder_of_json_is_a_frame_each(tmp_path, figures):
    for k, mask in enumerate(figures):
        content = json.dumps([{"segmentation": runs(mask), "stability_score": 0.9}])
        (tmp_path / f"{k}.json").write_text(content)
    np.testing.assert_array_equal(read_masks(tmp_path).masks, figures)
    (tmp_path / "x.json").write_text(json.dumps(annotations(figures)))
    with pytest.raises(InputError, match=rf"takes, 'x\.json' of {len(figures)} masks: give one"):
        read_masks(tmp_path)


def test_boxes_alone_are_no_masks(tmp_path):
    content = {"annotations": [{"image_id": 0, "bbox": [1, 2, 3, 4], "segmentation": []}]}
    with pytest.raises(InputError, match="holds boxes, and no masks"):
        read(tmp_path, content)


@pytest.mark.parametrize(
    ("record", "why"),
    [
        ({"image_id": [1]}, "a value of another kind than it should .unhashable"),
        ({"score": "high"}, "a value of another kind"),
        ({"segmentation": {"size": [10**9, 10**9], "counts": [10**18]}}, "a size of 1000000000 x"),
        ({"segmentation": [[1, 1, float("nan"), 2, 3, 3]]}, "a corner is far outside"),
        ({"segmentation": [[1, 1, 1e12, 2, 3, 3]]}, "a corner is far outside"),
    ],
)
def test_values_of_another_kind_are_refused(record, why):
    images = [{"id": 1, "height": 8, "width": "6"}]
    own = {"image_id": 1, "segmentation": [[1, 1, 4, 1, 4, 6], []]}
    assert pictures_of_records({"images": images, "annotations": [own]}, "it")[0]
    with pytest.raises(InputError, match=f"it (holds|has) .*{why}"):
        pictures_of_records({"images": images, "annotations": [own | record]}, "it")

import pytest

from silpose.core.errors import InputError
from silpose.silhouette.masks.json_forms import records_of

RUNS = {"size": [2, 2], "counts": [1, 3]}


def images_of(content):
    return [record["image_id"] for record in records_of(content, "it").records]


def test_masks_by_frame_and_object_as_trackers_write_them():
    content = {"0": {"1": RUNS, "2": RUNS}, "1": {}, "10": {"1": RUNS}}
    held = records_of(content, "it").records
    assert [(r["image_id"], r.get("track_id")) for r in held] == [
        (0, "1"),
        (0, "2"),
        (1, None),
        (10, "1"),
    ]
    assert images_of({"0": RUNS, "1": RUNS}) == [0, 1]


def test_objects_of_a_video():
    annotations = [{"video_id": 3, "segmentations": [RUNS, None]}] * 2
    held = records_of({"videos": [], "annotations": annotations}, "it").records
    assert [(r["image_id"], r["track_id"]) for r in held] == [(0, 1), (1, 1), (0, 2), (1, 2)]
    with pytest.raises(InputError, match="it holds 2 videos: give a file for each"):
        records_of([{"video_id": k, "segmentations": [RUNS]} for k in (1, 2)], "it")


def test_segments_of_one_image_are_numbered_from_the_largest():
    segments = [{"segmentation": RUNS, "area": a, "stability_score": 0.9} for a in (5, 90, 20)]
    held = records_of(segments, "it").records
    assert {r["image_id"] for r in held} == {0}
    assert [(r["track_id"], r["area"]) for r in held] == [(1, 90), (2, 20), (3, 5)]


def test_masks_without_images_are_frames():
    assert images_of([{"segmentation": RUNS}, {"segmentation": RUNS}]) == [0, 1]
    assert images_of([RUNS, None, RUNS]) == [0, 2]
    assert len(records_of([RUNS, None], "it").images) == 2
    assert images_of(RUNS) == [0]


def test_uncertain_detections_and_other_categories_are_left_out():
    detections = [
        {"image_id": 1, "category_id": 1, "score": 0.9, "segmentation": RUNS},
        {"image_id": 1, "category_id": 1, "score": 0.1, "segmentation": RUNS},
        {"image_id": 1, "category_id": 3, "score": 0.9, "segmentation": RUNS},
    ]
    held = records_of(detections, "it")
    assert held.records == detections[:1]
    assert held.doubts == (
        "it has several categories without names: 1 is taken for the person, as in COCO",
    )


def of_categories(*categories):
    return [{"image_id": 1, "category_id": c, "segmentation": RUNS} for c in categories]


def test_people_of_detectors_that_count_from_0():
    held = records_of(of_categories(0, 56), "it")
    assert [record["category_id"] for record in held.records] == [0]
    assert "0 is taken for the person, as in COCO counted from 0" in held.doubts[0]


def test_people_are_of_the_category_of_that_name():
    named = [{"id": 7, "name": "person"}, {"id": 1, "name": "car"}]
    held = records_of({"annotations": of_categories(1, 7), "categories": named}, "it")
    assert [record["category_id"] for record in held.records] == [7]
    assert held.doubts == ()


def test_categories_without_a_person_are_not_thrown_together():
    assert len(records_of(of_categories(7, 7), "it").records) == 2
    with pytest.raises(InputError, match="it has the categories '7', '9', and none of them"):
        records_of(of_categories(7, 9), "it")
    named = [{"id": 1, "name": "dog"}, {"id": 2, "name": "cat"}]
    with pytest.raises(InputError, match="it has the categories 'cat', 'dog', and none of them"):
        records_of({"annotations": of_categories(1, 2), "categories": named}, "it")


OTHERS = {
    "is of Label Studio: export": [{"data": {}, "annotations": [{"result": []}]}],
    "is of VIA: export": {"a.png1": {"filename": "a.png", "regions": []}},
    "is of Supervisely: export": {"size": {"height": 1}, "objects": []},
    "holds boxes, and no masks": {"annotations": [{"image_id": 1, "bbox": [1, 2, 3, 4]}]},
    "holds joints of bodies": [{"image_id": 1, "segmentation": [], "keypoints": [0] * 51}],
}


@pytest.mark.parametrize("message", OTHERS)
def test_other_forms_are_called_by_their_names(message):
    with pytest.raises(InputError, match=f"it {message}"):
        records_of(OTHERS[message], "it")


@pytest.mark.parametrize(
    "content",
    [None, 3, "text", [], {}, {"a": 1}, {"a": {"1": RUNS}}, {"0": 3}, [1], [{"a": 1}]],
)
def test_what_holds_no_masks_is_refused(content):
    with pytest.raises(InputError, match=r"it holds no masks|item 0 of it is no mask"):
        records_of(content, "it")


def test_images_with_annotations_of_their_own_are_those_of_grounded_sam():
    def image(*found):
        masks = [{"class_name": n, "segmentation": RUNS, "score": [s]} for n, s in found]
        return {"image_path": "a.jpg", "annotations": masks, "img_height": 2, "img_width": 2}

    content = [image(("person.", 0.9), ("car", 0.9), ("person", 0.2)), image()]
    held = records_of(content, "it")
    assert [(r["image_id"], r["category_id"]) for r in held.records] == [(0, "person")]
    assert [i["height"] for i in held.images] == [2, 2]
    assert len(records_of(content[0], "it").images) == 1
    with pytest.raises(InputError, match="none of them is called 'person'"):
        records_of(image(("car", 0.9), ("dog", 0.9)), "it")

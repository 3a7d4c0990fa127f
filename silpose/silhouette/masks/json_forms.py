"""Forms of JSON that hold masks, brought to one: a record for each mask, with its image."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from silpose.core.errors import InputError
from silpose.silhouette.masks.labelme import dataset_of_labelme, is_labelme
from silpose.silhouette.masks.run_lengths import is_run_lengths

WANTED = (
    "give COCO annotations or results, or a list of masks {'size': [H, W], 'counts': …}, "
    "one for each frame"
)

_PERSON = ("person", "people", "human", "pedestrian")
_COCO_PERSON = 1
_COUNTED_FROM_0 = 0  # the same of detectors that count from 0
_LISTED = 5  # categories that a message names
_LEAST_SCORE = 0.5  # of a detection
_SEGMENTS = ("stability_score", "crop_box", "point_coords")  # of one image, cut in all its parts

Record = Mapping[str, Any]


@dataclass(frozen=True)
class Records:
    """Masks by image.

    Attributes
    ----------
    records : list of mapping
        Each with ``segmentation``, ``image_id`` and, perhaps, ``track_id``.
    images : list of mapping
        Each with ``id`` and, perhaps, ``file_name``, ``height`` and ``width``; those that no
        record names are blank.
    doubts : tuple of str
    """

    records: list[Record]
    images: list[Record] = field(default_factory=list)
    doubts: tuple[str, ...] = ()


def is_record(item: object) -> bool:
    """Whether an item of a list is a mask as JSON files hold it."""
    return isinstance(item, Mapping) and ("segmentation" in item or is_run_lengths(item))


def records_of(content: Any, source: str) -> Records:
    """Bring JSON to records.

    Parameters
    ----------
    content : mapping or sequence
        A COCO or YouTube-VIS dataset, COCO results, the segments of SAM, polygons of LabelMe, run
        lengths by frame and object, or a list of run lengths, one a frame.
    source : str
        What it is called in messages.
    """
    images: list[Record] = []
    content = _images_with_masks(content) or content
    if why := _why_not_read(content):
        raise InputError(f"{source} {why}")
    if is_labelme(content):
        content = dataset_of_labelme({str(content.get("imagePath")): content}, source)
    if isinstance(content, Mapping) and "annotations" in content:
        images = list(content.get("images") or [])
        content, doubts = _people(
            content["annotations"] or [], content.get("categories") or [], source
        )
    elif isinstance(content, Mapping):
        content, doubts = [content] if is_record(content) else _by_frame(content), ()
    elif isinstance(content, Sequence) and not isinstance(content, str):
        content, doubts = _people(content, [], source)
    if not isinstance(content, Sequence) or isinstance(content, str) or not (content or images):
        raise InputError(f"{source} holds no masks: {WANTED}")
    if all(isinstance(item, Mapping) and "segmentations" in item for item in content):
        return Records(_of_videos(content, source), images, doubts)
    if all(item is None or is_run_lengths(item) for item in content):
        return _frames(content)
    for position, item in enumerate(content):
        if not is_record(item):
            raise InputError(f"item {position} of {source} is no mask: {WANTED}")
    return Records(_with_images(content), images, doubts)


def _people(records: Any, categories: Sequence[Record], source: str) -> tuple[Any, tuple[str, ...]]:
    """Keep people, as far as categories tell, and what was detected with some certainty."""
    if not all(isinstance(record, Mapping) for record in records):
        return records, ()
    kept = [record for record in records if _score(record) >= _LEAST_SCORE] or list(records)
    people = {c.get("id") for c in categories if str(c.get("name", "")).lower() in _PERSON}
    if people:
        return [r for r in kept if r.get("category_id") in people], ()
    if any("class_name" in record for record in kept):
        kept = [r | {"category_id": str(r.get("class_name")).lower().strip(" .")} for r in kept]
    found = {r.get("category_id") for r in kept if "category_id" in r}
    if not found.isdisjoint(_PERSON):
        return [r for r in kept if r.get("category_id") in _PERSON], ()
    if len(found) < 2:
        return kept, ()
    for person, where in ((_COUNTED_FROM_0, " counted from 0"), (_COCO_PERSON, "")):
        if person in found and not categories:
            doubt = (
                f"{source} has several categories without names: {person} is taken for the "
                f"person, as in COCO{where}"
            )
            return [r for r in kept if r.get("category_id") == person], (doubt,)
    names = {c.get("id"): str(c.get("name")) for c in categories}
    listed = ", ".join(sorted(f"'{names.get(key, key)}'" for key in found)[:_LISTED])
    raise InputError(
        f"{source} has the categories {listed}, and none of them is called 'person': leave in it "
        "those of the person, or call them so in 'categories'"
    )


def _score(record: Record) -> float:
    """Certainty of a detection, which some programs write as a list of one."""
    score: Any = record.get("score")
    score = score[0] if isinstance(score, list) and score else score
    return 1.0 if score is None else float(score)


def _images_with_masks(content: Any) -> Record | None:
    """Join images of which each has its own annotations, as Grounded SAM 2 gives them."""
    items = [content] if isinstance(content, Mapping) and "images" not in content else content
    if not isinstance(items, Sequence) or not items:
        return None
    if not all(_has(item, "annotations") and _has(item, "img_height") for item in items):
        return None
    images = [
        {
            "id": k,
            "file_name": i.get("image_path"),
            "height": i["img_height"],
            "width": i.get("img_width"),
        }
        for k, i in enumerate(items)
    ]
    annotations = [r | {"image_id": k} for k, i in enumerate(items) for r in i["annotations"]]
    return {"images": images, "annotations": annotations}


def _why_not_read(content: Any) -> str | None:
    """Say what JSON is that holds masks in another form, or none, and what to do with it."""
    inside = content["annotations"] if _has(content, "annotations") else content
    values = inside.values() if isinstance(inside, Mapping) else inside
    items = [*values] if isinstance(values, Sequence | Iterable) else []
    items = [] if isinstance(values, str) else items
    if _has(content, "objects") and _has(content, "size"):
        return "is of Supervisely: export the annotations as COCO, or as mask images"
    first = items[0] if items else None
    if _has(first, "regions") and _has(first, "filename"):
        return "is of VIA: export the annotations as COCO"
    if _has(first, "annotations") or _has(first, "completions"):
        return (
            "is of Label Studio: export polygons as COCO, and brushes as PNG, of which give the "
            "folder"
        )
    records = [item for item in items if isinstance(item, Mapping)]
    masked = any(r.get("segmentation") is not None and r["segmentation"] != [] for r in records)
    for key, words in (("keypoints", "joints of bodies"), ("bbox", "boxes")):
        if records and not masked and any(key in record for record in records):
            return f"holds {words}, and no masks: export it with segmentations"
    return None


def _has(content: object, key: str) -> bool:
    return isinstance(content, Mapping) and key in content


def _by_frame(content: Record) -> list[Record] | None:
    """Read a mapping from frames to masks, or to masks by object, as SAM 2 and trackers give it."""
    if not content or not all(str(key).lstrip("-").isdecimal() for key in content):
        return None
    records: list[Record] = []
    for frame, held in content.items():
        alone = is_run_lengths(held) or hasattr(held, "__array__")
        objects = {1: held} if alone else held
        if not isinstance(objects, Mapping):
            return None
        records += [
            {"image_id": int(frame), "track_id": key, "segmentation": mask}
            for key, mask in objects.items()
        ]
        if not objects:
            records.append({"image_id": int(frame), "segmentation": None})
    return records


def _of_videos(annotations: Sequence[Record], source: str) -> list[Record]:
    """Take the frames of each object of a video."""
    videos = {annotation.get("video_id") for annotation in annotations}
    if len(videos) > 1:
        raise InputError(f"{source} holds {len(videos)} videos: give a file for each")
    return [
        {"image_id": frame, "track_id": position + 1, "segmentation": mask}
        for position, annotation in enumerate(annotations)
        for frame, mask in enumerate(annotation["segmentations"])
    ]


def _frames(masks: Sequence[Record | None]) -> Records:
    """Take one mask for each frame, None for a blank one."""
    images = [{"id": k, "file_name": f"frame {k}"} for k in range(len(masks))]
    return Records(
        [{"image_id": k, "segmentation": m} for k, m in enumerate(masks) if m is not None],
        list(images),
    )


def _with_images(records: Sequence[Record]) -> list[Record]:
    """Say which image each record belongs to, if none does."""
    own: list[Record] = [r if "segmentation" in r else {"segmentation": r} for r in records]
    if any("image_id" in record for record in own):
        return own
    if any(key in record for record in own for key in _SEGMENTS):
        own = sorted(own, key=lambda record: -float(record.get("area", 0)))
        return [{**r, "image_id": 0, "track_id": k + 1} for k, r in enumerate(own)]
    return [{**r, "image_id": k} for k, r in enumerate(own)]

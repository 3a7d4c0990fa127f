"""Polygons of LabelMe, which has a JSON file for each image, brought to a dataset of COCO."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from silpose.core.errors import InputError

_POLYGON = "polygon"


def is_labelme(content: object) -> bool:
    """Whether JSON is of LabelMe."""
    return isinstance(content, Mapping) and "shapes" in content


def dataset_of_labelme(files: Mapping[str, Mapping[str, Any]], source: str) -> Mapping[str, Any]:
    """Bring polygons to a dataset of COCO.

    Parameters
    ----------
    files : mapping of str to mapping
        What the files hold, each under the name that its image gets. One without shapes is an
        image in which nobody is.
    source : str
        What they are called in messages.

    Returns
    -------
    dataset : mapping
        With ``images``, ``annotations`` and ``categories``, one for each label.

    Raises
    ------
    InputError
        If there are shapes, and no polygons among them.
    """
    images = [
        {
            "id": name, "file_name": name,
            "height": content.get("imageHeight"), "width": content.get("imageWidth"),
        }
        for name, content in files.items()
    ]  # fmt: skip
    shapes = [(name, shape) for name, content in files.items() for shape in content["shapes"]]
    kinds = {str(shape.get("shape_type", _POLYGON)) for _, shape in shapes}
    if kinds and _POLYGON not in kinds:
        raise InputError(
            f"{source} holds shapes of the kind {', '.join(sorted(kinds))}, and no polygons: "
            "outline the person by polygons"
        )
    annotations = [
        {
            "image_id": name,
            "category_id": shape.get("label"),
            "segmentation": [[value for point in shape["points"] for value in point]],
        }
        for name, shape in shapes
        if shape.get("shape_type", _POLYGON) == _POLYGON
    ]
    labels = sorted({str(annotation["category_id"]) for annotation in annotations})
    categories = [{"id": label, "name": label} for label in labels]
    return {"images": images, "annotations": annotations, "categories": categories}

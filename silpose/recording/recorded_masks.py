"""Reading the masks of a recording back, and the skeletons on them."""

from __future__ import annotations

import io
from collections.abc import Iterator, Mapping
from pathlib import Path

import numpy as np
from PIL import Image

from silpose.core.types import Array, Mask
from silpose.recording import entity_paths
from silpose.recording.read import reader

_MASK_CLASSES = (1, 2)  # of segmentation images: the mask alone, or with a body or without


def read_masks(recording: str | Path) -> Mapping[int, Mask]:
    """Read the masks of a recording.

    Parameters
    ----------
    recording : path
        An ``.rrd`` file.

    Returns
    -------
    masks : mapping of int to ndarray, each (H, W)
        By frame, in their order; empty if there are none. Those of films are decoded when they
        are asked for.
    """
    masks: dict[int, Mask | bytes] = {}
    entities = [entity_paths.MASK, entity_paths.OVERLAP]
    for chunk in reader(recording).stream().filter(content=entities):
        batch = chunk.to_record_batch()
        names = {name.rpartition(":")[2]: name for name in batch.schema.names}
        if chunk.is_static or "frame" not in names:
            continue
        frames = batch.column("frame").to_pylist()
        if {"buffer", "format"} <= {*names}:
            columns = (batch.column(names[name]) for name in ("buffer", "format"))
            for frame, (buffer,), (image,) in zip(frames, *columns, strict=True):
                flat = np.isin(buffer.values, _MASK_CLASSES).astype(np.uint8)
                masks[frame] = flat.reshape(image["height"].as_py(), image["width"].as_py())
        elif "blob" in names:
            for frame, (blob,) in zip(frames, batch.column(names["blob"]), strict=True):
                masks[frame] = np.asarray(blob.values).tobytes()
    return _Masks(dict(sorted(masks.items())))


def read_overlay(recording: str | Path) -> dict[int, Array]:
    """Read the skeleton on the masks of a recording.

    Parameters
    ----------
    recording : path
        An ``.rrd`` file.

    Returns
    -------
    bones : dict of int to ndarray, shape (B, 2, 2)
        Ends of each bone, pixels to the right and down, by frame.
    """
    bones: dict[int, Array] = {}
    for chunk in reader(recording).stream().filter(content=[entity_paths.OVERLAID_SKELETON]):
        batch = chunk.to_record_batch()
        name = next((n for n in batch.schema.names if n.endswith(":strips")), None)
        if not chunk.is_static and name is not None:
            rows = zip(batch.column("frame").to_pylist(), batch.column(name), strict=True)
            bones |= {frame: np.array(own.as_py()).reshape(-1, 2, 2) for frame, own in rows}
    return bones


class _Masks(Mapping[int, Mask]):
    """Masks by frame, of which some are PNGs of a colour each for background and person."""

    def __init__(self, parts: Mapping[int, Mask | bytes]) -> None:
        self._parts = parts

    def __getitem__(self, frame: int) -> Mask:
        part = self._parts[frame]
        if not isinstance(part, bytes):
            return part
        with Image.open(io.BytesIO(part)) as image:
            return np.asarray(image, np.uint8)

    def __iter__(self) -> Iterator[int]:
        return iter(self._parts)

    def __len__(self) -> int:
        return len(self._parts)

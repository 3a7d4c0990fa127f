"""One recording of every kind, what is in it, and whether it can be drawn here."""

import os
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest
from rerun.chunk import RrdReader
from video_steps import video_steps

from silpose.core.pose_space import ANGLES
from silpose.descriptor import ShapeContextHistogram
from silpose.descriptor.context_space import ContextSpace
from silpose.evaluation.gait import GaitReport, Stride
from silpose.fitting import Trace
from silpose.recording import (
    GroundTruth,
    Header,
    record_bridges,
    record_context_space,
    record_extinction,
    record_features,
    record_fitting,
    record_hypotheses,
    record_modes,
    record_motion,
    record_prediction,
    record_study,
    record_tracking,
    video_recording,
)
from silpose.silhouette import Camera
from silpose.tracking import Track


def vulkan():
    places = (Path("/usr/share/vulkan/icd.d"), Path("/etc/vulkan/icd.d"))
    return any(place.is_dir() and any(place.iterdir()) for place in places)


@pytest.fixture
def drawing():
    """CI has a Vulkan driver, and fails where it is missing."""
    if not vulkan() and not os.environ.get("CI"):
        pytest.skip("no Vulkan driver")


@pytest.fixture(scope="session")
def logged():
    """Values of one component of an entity, in the order of frames."""

    def read(recording, entity, component, static=False):
        values = []
        for chunk in RrdReader(recording).stream().filter(content=entity, is_static=static):
            batch = chunk.to_record_batch()
            if component in batch.schema.names:
                frames = [0] * batch.num_rows if static else batch.column("frame").to_pylist()
                values += zip(frames, batch.column(component).to_pylist(), strict=True)
        return [value for _, value in sorted(values, key=lambda pair: pair[0])]

    return read


@pytest.fixture(scope="session")
def header():
    """The header of a recording with results and settings."""

    def of(path, **more):
        results = {"rvm": {"error": 1.0}}
        return Header(path.stem, "001", path, "a take", "seed: 0\n", results, **more)

    return of


@pytest.fixture(scope="session")
def modes(sequence):
    """Weights (F, 2) and means (F, 2, D); every other frame has one mode only."""
    weights = np.tile([0.7, 0.3], (len(sequence), 1))
    weights[::2] = [1.0, 0.0]
    return weights, np.stack([sequence.x, sequence.x[::-1]], axis=1)


@pytest.fixture(scope="session")
def states(sequence):
    return ["starting", *["tracking"] * 20, *["lost"] * (len(sequence) - 21)]


@pytest.fixture(scope="session")
def recordings(finished, sequence, modes, states, header, tmp_path_factory):
    """One file of every kind of recording."""
    folder = tmp_path_factory.mktemp("kinds")
    figure = folder / "figure.png"
    cv2.imwrite(str(figure), np.full((40, 60, 3), 128, np.uint8))
    paths = {"single_image": finished.recording}

    def head(kind):
        paths[kind] = folder / f"{kind}.rrd"
        return header(paths[kind], figure=figure)

    masks, frames = sequence.masks, len(sequence)
    errors = {"usual": np.arange(5.0), "narrow": np.arange(5.0)}
    record_study(head("study"), errors, "errors", 15.0)
    record_motion(head("motion"), sequence.x, np.ones((frames, 3)), 15.0)
    norms = np.array([[1.0, 2.0, 3.0], [0.0, 2.0, 3.0]])
    record_bridges(head("bridges"), norms, np.array([9.0, 8.0]))
    points = [np.argwhere(mask)[:9, ::-1].astype(np.int32) for mask in masks]
    marked = {part: [np.arange(9) % 2 > k for _ in points] for k, part in enumerate(("arm", "leg"))}
    record_features(head("features"), masks, points, marked, 15.0)
    kernels = {"usual": np.eye(5), "narrow": np.zeros((5, 5))}
    record_extinction(head("extinction"), kernels, errors, 15.0)

    few = masks[:6]
    descriptor = ShapeContextHistogram(codebook_size=9).fit(few)
    described = descriptor.describe(few)
    space = ContextSpace(
        *(c[:, :2] for c in (described[0].contexts, descriptor.codebook_)),
        [d.contexts[:, :2] for d in described],
    )
    codebook = descriptor.codebook_
    record_context_space(head("context_space"), few, described, space, codebook, 12, 15.0)

    details = finished.model.explain(masks[:6])
    poses = replace(finished.model.predict(details), confidence=np.linspace(0.2, 0.9, 6))
    record_prediction(head("prediction"), finished.model, details, poses)

    truth = GroundTruth.of(sequence, Camera(), {"tracker": np.zeros(frames)}, ANGLES)
    track = Track(sequence.x, states, np.eye(frames))
    tracks = {"ridge": sequence.x, "tracker": sequence.x}
    facing = np.linspace(-180, 179, frames)
    record_tracking(head("tracking"), sequence, truth, tracks, track, facing, ANGLES)
    named = GroundTruth.of(sequence, Camera(), {"best of 2": np.zeros(frames)}, ANGLES)
    record_modes(head("modes"), sequence, named, *modes, ANGLES)
    weights, means = modes
    many = Track(sequence.x, states, weights=weights, means=means)
    record_hypotheses(head("hypotheses"), sequence, truth, modes, many, ANGLES)

    falling = np.array([30.0, 9.0, 4.0])
    trace = Trace(masks[8], sequence.x[6:9], list(masks[6:9]), np.array([0.6, 0.8, 1.0]), falling)
    fits = GroundTruth.of(sequence, Camera(), {"fitted_take": np.zeros(frames)}, ANGLES)
    silhouettes = {"before": np.roll(masks, 3, axis=2), "after": masks}
    shares = {"fitted_take": np.ones(frames)}
    record_fitting(
        *(head("fitting"), sequence, fits, sequence.x[::-1], sequence.x),
        *(silhouettes, shares, trace, 8, ANGLES),
    )

    with video_recording(head("video"), (96, 96), 15.0, live=True) as recorder:
        for step in video_steps(sequence, 5, lost=(2,), live=True):
            recorder.log(step)
        stride = Stride("left", 0.0, 0.1, 0.2, 0.2, 0.3, *[1.0] * 5, False, 1.0, (0, 4))
        recorder.log_gait(GaitReport((), (stride,), (), (), "forward", ()))
    return paths

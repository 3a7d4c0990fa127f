"""Pose from each silhouette on its own: section IV-B of the paper, Figs. 9 and 10."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from silpose.dataset import Dataset, poses
from silpose.dataset import Sequence as Take
from silpose.descriptor import ShapeContextHistogram
from silpose.errors import InputError
from silpose.evaluation import baselines, measure
from silpose.experiments.figures import single_image_figure
from silpose.experiments.rooms import Rooms
from silpose.model import PoseModel
from silpose.progress import bar
from silpose.recording import Truth, record_single_image, texts
from silpose.regression import check_methods
from silpose.run import Run

Array = NDArray[np.float64]


def single_image(rooms: Rooms, run: Run, methods: Sequence[str], show: str) -> None:
    """Learn to see pose in silhouettes, and look at how well it goes on unseen sequences.

    Parameters
    ----------
    rooms : Rooms
    run : Run
    methods : sequence of str
        Regression methods; the baselines stand beside them always.
    show : str
        The method to draw and to keep.
    """
    if rooms.own_masks.source is not None:
        raise InputError("one's own masks have no true poses to learn: add experiment=predict")
    check_methods(methods)
    if show not in methods:
        raise InputError(f"show={show} is none of the methods {', '.join(methods)}")
    with run.stage("masks"):
        data = rooms.dataset()
    with run.stage("descriptors"):
        descriptor = rooms.descriptor.fit([m for take in data.train for m in take.masks])
        z_train, z_validation, z_test = (
            describe(descriptor, takes) for takes in (data.train, data.validation, data.test)
        )
    x_train, x_validation, x_test = (
        poses(takes) for takes in (data.train, data.validation, data.test)
    )
    with run.stage("regression"):
        chosen = rooms.candidates.choose(
            methods,
            (z_train, x_train),
            (z_validation, x_validation),
            lambda true, estimated: data.space.distance(true, estimated).mean(),
        )
    with run.stage("evaluation"):
        estimates = baselines(data.space, z_train, x_train, z_test, x_test)
        estimates |= {m: chosen.regressors[m].predict(z_test) for m in methods}
        metrics = {m: measure(data.space, x_test, e, x_train) for m, e in estimates.items()}
        for method in methods:
            metrics[method]["kept"] = chosen.regressors[method].kept_
    model = PoseModel(
        descriptor, chosen.regressors[show], data.space, data.test[0].frames_per_second
    )
    with run.stage("recording"):
        _write(rooms, run, data, model, estimates, metrics, show)
    run.write_settings()
    run.write_results([*chosen.rows, *_tidy(metrics)])
    run.write_metrics(data.name, rooms.seed, metrics)


def describe(descriptor: ShapeContextHistogram, takes: Sequence[Take]) -> Array:
    """Descriptors of all frames of some takes, with a progress bar, shape (n, d)."""
    with bar("descriptors", sum(len(take) for take in takes)) as advance:
        blocks = []
        for take in takes:
            blocks.append(descriptor.transform(take.masks))
            advance(len(take))
    return np.concatenate(blocks)


def _write(
    rooms: Rooms,
    run: Run,
    data: Dataset,
    model: PoseModel,
    estimates: dict[str, Array],
    metrics: dict[str, dict[str, float]],
    show: str,
) -> None:
    take = data.test[0]
    frames = slice(0, len(take))  # the first test sequence is the one to look at
    errors = {m: data.space.distance(take.x, e[frames]) for m, e in estimates.items()}
    with run.writing("model.npz") as path:
        model.save(path)
    with run.writing("run.rrd") as path:
        record_single_image(
            path,
            f"{run.experiment}/{run.name}",
            model,
            model.look(take.masks),
            Truth.of(take, rooms.camera, errors),
            [show, "nearest", "mean_pose"],
            texts(f"test sequence {take.name} by {take.performer}", run.settings, metrics),
        )
    with run.writing("single_image.png") as path:
        single_image_figure(
            path,
            data.space,
            rooms.camera,
            take.masks,
            take.x,
            estimates[show][frames],
            take.offset,
            {m: values[data.space.metrics[0]] for m, values in metrics.items()},
            show,
        )


def _tidy(metrics: dict[str, dict[str, float]]) -> list[dict[str, object]]:
    return [
        {"method": method, "metric": name, "value": value}
        for method, values in metrics.items()
        for name, value in values.items()
    ]

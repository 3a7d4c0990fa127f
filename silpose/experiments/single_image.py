"""Pose from each silhouette on its own: section IV-B of the paper, Figs. 9 and 10."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from silpose.core.errors import InputError
from silpose.evaluation import heading_confidence, key_angles
from silpose.experiments.figures import single_image_figure
from silpose.experiments.setup import Components
from silpose.model.pose_model import PoseModel
from silpose.model.training import DescribedDataset, compare, prepare, tidy
from silpose.recording import Reasons, Truth, record_single_image
from silpose.recording.runs.run_folder import Run
from silpose.regression import check_methods

Array = NDArray[np.float64]


def single_image(rooms: Components, run: Run, methods: Sequence[str], show: str) -> None:
    """Learn to see pose in silhouettes, and look at how well it goes on unseen sequences.

    Parameters
    ----------
    rooms : Components
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
    described = prepare(rooms, run)
    with run.stage("regression"):
        chosen = described.learn(rooms.candidates, methods)
    with run.stage("evaluation"):
        estimates, metrics = compare(described, chosen.regressors)
        for method in methods:
            true = np.concatenate([x for _, x in described.test])
            metrics[method] |= heading_confidence(described.data.space, true, estimates[method])
        keys = key_angles(described.data.space, true, estimates[show])
    with run.stage("recording"):
        model = described.model(chosen.regressors[show])
        _write(rooms, run, described, model, estimates, metrics, keys, show)
    run.write_settings()
    run.write_results([*chosen.rows, *tidy(metrics), *({"method": show, **row} for row in keys)])
    run.write_metrics(described.data.name, rooms.seed, metrics)


def _write(
    rooms: Components,
    run: Run,
    described: DescribedDataset,
    model: PoseModel,
    estimates: dict[str, Array],
    metrics: dict[str, dict[str, float]],
    keys: list[dict[str, object]],
    show: str,
) -> None:
    data, take = described.data, described.data.test[0]  # the first test sequence is looked at
    camera = take.camera or rooms.camera
    frames = slice(0, len(take))
    errors = {m: data.space.distance(take.x, e[frames]) for m, e in estimates.items()}
    look = (
        model.explain(np.asarray(take.masks))
        if take.masks is not None
        else model.explain_descriptors(described.test[0][0])
    )
    with run.writing("model.npz") as path:
        model.save(path)
    record_single_image(
        run.header(
            f"test sequence {take.name} by {take.performer}; RMS errors of {show}: "
            + ", ".join(_in_words(key) for key in keys),
            metrics,
        ),
        model,
        look,
        Truth.of(take, camera, errors, data.space),
        [show, "nearest", "mean_pose"],
        Reasons.of(model.regressor, look, data.train, rooms.camera, data.space),
    )
    with run.writing("single_image.png") as path:
        single_image_figure(
            path,
            data.space,
            camera,
            take,
            estimates[show][frames],
            {m: values[data.space.metrics[0]] for m, values in metrics.items()},
            show,
        )


def _in_words(key: dict[str, object]) -> str:
    angle = str(key["metric"]).removesuffix("_rms_deg").replace("_", " ")
    return f"{angle} {key['value']:.1f}° in a range of {key['range_deg']:.0f}°"

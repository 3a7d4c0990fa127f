"""Pose from each silhouette on its own: section IV-B of the paper, Figs. 9 and 10."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial

from silpose.core.errors import InputError
from silpose.core.types import Array, Row
from silpose.evaluation import heading_confidence, key_angles
from silpose.experiments.setup import Components, fitter_of_model, prepare, tidy
from silpose.experiments.single_image_figure import single_image_figure
from silpose.model import DescribedDataset, PoseModel, compare
from silpose.recording import (
    GroundTruth,
    Header,
    InfluentialExamples,
    Recording,
    Result,
    record_single_image,
)
from silpose.regression import check_methods
from silpose.silhouette import Camera


def single_image(
    components: Components,
    *,
    methods: Sequence[str] = ("ridge", "rvm", "rvm_18", "rvm_6"),
    show: str = "rvm",
) -> Result:
    """Train and evaluate single-image regressors.

    Parameters
    ----------
    components : Components
    methods : sequence of str, default=("ridge", "rvm", "rvm_18", "rvm_6")
        Regression methods; the baselines stand beside them always.
    show : str, default="rvm"
        The method that is drawn in the recording and kept in ``model.npz``.
    """
    if components.masks.source is not None:
        raise InputError(
            "masks of one's own have no true poses to train on: add experiment=predict"
        )
    check_methods(methods)
    if show not in methods:
        raise InputError(f"show={show} is none of the methods {', '.join(methods)}")
    described = prepare(components)
    chosen = described.choose(components.regression, methods)
    headline = chosen.validation_error(show)
    estimates, metrics = compare(described, chosen.regressors)
    space, (_, true) = described.data.space, described.joined("test")
    for method in methods:
        metrics[method] |= heading_confidence(space, true, estimates[method])
    angles = key_angles(space, true, estimates[show])
    usual = chosen.regressors.get("ridge", chosen.regressors[show])
    fitter = fitter_of_model(components, described, usual)
    model = described.model(chosen.regressors[show], fitter=fitter)
    take = described.data.test[0]
    camera = take.camera_or(components.camera)
    of_take = {method: x[: len(take)] for method, x in estimates.items()}
    errors = {method: values[space.metrics[0]] for method, values in metrics.items()}
    words = f"Shown: {take.title}; RMS errors of {show}: {', '.join(map(_in_words, angles))}"
    record = partial(_record, described, model, of_take, show, components.camera)
    return Result(
        described.data.name,
        metrics,
        rows=[*chosen.rows, *tidy(metrics), *({"method": show, **row} for row in angles)],
        figure=single_image_figure(space, camera, take, of_take[show], errors, show),
        recording=Recording(words, record),
        model=model,
        headline=headline,
    )


def _record(
    described: DescribedDataset,
    model: PoseModel,
    estimates: Mapping[str, Array],
    show: str,
    default_camera: Camera,
    header: Header,
) -> None:
    """Record the first test take with all intermediate results."""
    data, take = described.data, described.data.test[0]
    details = (
        model.explain(take.mask_array())
        if take.has_masks
        else model.explain_descriptors(described.test[0][0])
    )
    errors = {method: data.space.distance(take.x, x) for method, x in estimates.items()}
    record_single_image(
        header,
        model,
        details,
        GroundTruth.of(take, take.camera_or(default_camera), errors, data.space),
        [show, "nearest", "mean_pose"],
        InfluentialExamples.of(model.regressor, details, data.train, default_camera, data.space),
    )


def _in_words(row: Row) -> str:
    angle = str(row["metric"]).removesuffix("_rms_deg").replace("_", " ")
    return f"{angle} {row['value']:.1f}° in a range of {row['range_deg']:.0f}°"

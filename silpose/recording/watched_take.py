"""What a model makes of a take, recorded and shown in a notebook, by one call."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from silpose.core.errors import InputError
from silpose.descriptor import ContextSpace, ShapeContextHistogram
from silpose.fitting import fitted_silhouettes, overlap, trace_frame
from silpose.recording.fitting import record_fitting
from silpose.recording.ground_truth import GroundTruth
from silpose.recording.header import Header
from silpose.recording.hypotheses import record_hypotheses
from silpose.recording.influential_examples import InfluentialExamples
from silpose.recording.single_image import record_single_image
from silpose.recording.study import record_context_space
from silpose.recording.tracking import record_tracking
from silpose.recording.viewer import show
from silpose.silhouette import Camera, render
from silpose.tracking import BeliefTracker, MultipleHypothesisTracker

if TYPE_CHECKING:
    from silpose.dataset import Take
    from silpose.model import PoseModel

_MODES = 4  # of each silhouette, and of the tracker
_MASKS = 60  # training masks, about, whose shape contexts are drawn


def watch(
    model: PoseModel | ShapeContextHistogram,
    take: Take,
    training: Sequence[Take] = (),
    *,
    file: str | Path | None = None,
    height: int = 720,
) -> Any:
    """Record what a model makes of a take, and show it in the viewer below the cell.

    A model with a fitter shows the body that is fitted to the masks, one with a tracker the track
    beside the estimates of single silhouettes, and any other how a mask becomes a pose. A
    descriptor alone shows its shape contexts and their codebook.

    Parameters
    ----------
    model : PoseModel or ShapeContextHistogram
        Fitted.
    take : Take
        With masks; its true poses are shown beside the estimated ones.
    training : sequence of Take, optional
        Takes that the model was fitted to, in their order: then it is shown which of their
        silhouettes an estimate rests on, and the shape contexts that a codebook was learnt from.
    file : path, optional
        Where the recording is kept, an ``.rrd`` file; by default it is not.
    height : int, default=720
        Of the viewer, pixels.

    Returns
    -------
    viewer : rerun_notebook.Viewer

    Raises
    ------
    InputError
        If the take has no masks, or a blank one and the model a fitter; if the viewer for
        notebooks is not installed.

    See Also
    --------
    silpose.show : Shows a recording that there is.
    """
    take.mask_array()  # raises what is wrong with it
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "watch.rrd" if file is None else Path(file)
        header = Header("take", take.name, path, take.title)
        if isinstance(model, ShapeContextHistogram):
            _record_descriptor(header, model, take, training)
        elif model.fitter is not None:
            _record_fit(header, model, take)
        elif isinstance(model.tracker, MultipleHypothesisTracker):
            _record_hypotheses(header, model, model.tracker, take)
        elif isinstance(model.tracker, BeliefTracker):
            _record_track(header, model, model.tracker, take)
        elif model.tracker is None:
            _record_estimates(header, model, take, training)
        else:
            raise InputError(f"a {type(model.tracker).__name__} cannot be watched")
        return show(path, height)


def _truth(model: PoseModel, take: Take, estimates: dict[str, np.ndarray]) -> GroundTruth:
    """Measure the true poses, and the error of each method's estimates."""
    errors = {name: model.space.distance(take.x, x) for name, x in estimates.items()}
    return GroundTruth.of(take, take.camera_or(Camera()), errors, model.space)


def _record_descriptor(
    header: Header, descriptor: ShapeContextHistogram, take: Take, training: Sequence[Take]
) -> None:
    masks = take.mask_array()
    described = descriptor.describe(masks)
    known = [each for own in training for each in own.mask_array()] or list(masks)
    some = descriptor.describe(known[:: max(1, len(known) // _MASKS)])
    cloud = np.concatenate([description.contexts for description in some])
    record_context_space(
        header,
        masks,
        described,
        ContextSpace.of(cloud, descriptor.codebook_, described),
        descriptor.codebook_,
        descriptor.angular_bins,
        take.frames_per_second,
    )


def _record_estimates(
    header: Header, model: PoseModel, take: Take, training: Sequence[Take]
) -> None:
    details = model.explain(take.mask_array(), "nan")
    name = "estimated"
    truth = _truth(model, take, {name: details.x})
    examples = None
    if training:
        camera = take.camera_or(Camera())
        examples = InfluentialExamples.of(model.regressor, details, training, camera, model.space)
    record_single_image(header, model, details, truth, [name], examples)


def _record_track(header: Header, model: PoseModel, tracker: BeliefTracker, take: Take) -> None:
    details = model.explain(take.mask_array(), "nan")
    track = tracker.track(details.z)
    tracks = {"ridge": details.x, "tracker": track.x}
    facing = model.space.heading(tracker.examples_.headings)
    truth = _truth(model, take, tracks)
    record_tracking(header, take, truth, tracks, track, facing, model.space)


def _record_hypotheses(
    header: Header, model: PoseModel, tracker: MultipleHypothesisTracker, take: Take
) -> None:
    z = model.explain(take.mask_array(), "nan").z
    weights, means, _ = tracker.mixture_.predict_modes(np.nan_to_num(z), _MODES)
    weights[np.isnan(z).any(axis=1)] = 0
    track = tracker.track(z, modes=_MODES)
    truth = _truth(model, take, {"mixture_top1": means[:, 0], "hypotheses": track.x})
    record_hypotheses(header, take, truth, (weights, means), track, model.space)


def _record_fit(header: Header, model: PoseModel, take: Take) -> None:
    assert model.fitter is not None, "the caller has looked"
    masks, space = take.mask_array(), model.space
    details = model.explain(masks)
    fit = model.fitter.fit(
        list(masks), details.z, details.x, roots=take.offset,
        frames_per_second=take.frames_per_second,
    )  # fmt: skip
    fitter = model.fitter.fitter
    silhouettes = {
        "before": list(render(fitter.body, fitter.camera, space.rotations(details.x), take.offset)),
        "after": fitted_silhouettes(fitter, fit, take.offset),
    }
    tracks = {"ridge": details.x, "fitted_take": np.where(np.isfinite(fit.x), fit.x, details.x)}
    overlaps = {
        name: np.array([overlap(*pair) for pair in zip(masks, drawn, strict=True)])
        for name, drawn in zip(tracks, silhouettes.values(), strict=True)
    }
    worst = int(np.argmin(overlaps["ridge"]))
    trace = trace_frame(fitter, masks[worst], details.x[worst], root=take.offset[worst])
    truth, (before, after) = _truth(model, take, tracks), tracks.values()
    record_fitting(
        header, take, truth, before, after, silhouettes, overlaps, trace, worst, space,
        fitter.body.shape,
    )  # fmt: skip

"""Saved models, read back."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from silpose.core.errors import InputError
from silpose.core.pose_space import SPACES
from silpose.core.serialisation import State, without_prefix
from silpose.descriptor import ShapeContextHistogram
from silpose.model.confidence import Confidence
from silpose.model.model_file import read_model_file
from silpose.model.pose_fitter import PoseFitter
from silpose.model.pose_model import PARTS, PoseModel
from silpose.regression import REGRESSORS
from silpose.tracking import TRACKERS


def load(path: str | Path) -> PoseModel:
    """Load a model that `PoseModel.save` wrote.

    Parameters
    ----------
    path : path
        The ``.npz``, or the folder of the run that holds it.

    Raises
    ------
    InputError
        If there is no such file, or it is no model, or one of another format, or damaged.
    """
    header, state = read_model_file(path)
    try:
        return _model(header, state)
    except InputError:
        raise
    except (KeyError, ValueError, TypeError, AttributeError, IndexError) as error:
        raise InputError(f"'{path}' holds no model that silpose can use: train it again") from error


def _model(header: Mapping[str, Any], state: State) -> PoseModel:
    descriptor, regressor, tracker, fitter, confidence = (
        without_prefix(part, state) for part in PARTS
    )
    return PoseModel(
        ShapeContextHistogram.from_arrays(descriptor) if descriptor else None,
        REGRESSORS[header["regressor"]].from_arrays(regressor),
        SPACES[header["space"]],
        header["frames_per_second"],
        TRACKERS[header["tracker"]].from_arrays(tracker) if tracker else None,
        PoseFitter.from_arrays(fitter) if fitter else None,
        Confidence.from_arrays(confidence) if confidence else None,
    )

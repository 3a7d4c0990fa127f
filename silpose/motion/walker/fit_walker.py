"""Fit the statistical walker to folders of BVH walks.

Run ``python -m silpose.motion.walker.fit_walker ROOT [ROOT ...] [--output FILE]``. A folder's takes
may be of one performer or many; every performer has the same weight. Every walk is used together
with its mirror image, so that the mean walker is symmetric.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from collections.abc import Iterable
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from silpose.core.errors import InputError
from silpose.core.skeleton import ANGLES
from silpose.core.types import Array
from silpose.motion.capture.motion_folder import MotionFolder
from silpose.motion.motion import Motion
from silpose.motion.walker.gait import Steps, fit_harmonics, mirrored_gait, steady_steps
from silpose.motion.walker.walker import Variation
from silpose.motion.walker.walker_model import FILE, WalkerModel, pack

STRIDES = 4
"""Strides of the pieces that a stretch is cut into, as posture changes with the path's curve."""

VARIANCE = 0.95
"""Share of the variance that the principal components explain."""


def main() -> None:
    """Run the command."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("roots", nargs="+", metavar="ROOT", help="a folder of BVH walks")
    parser.add_argument("--output", default=str(FILE), help="the file to write")
    arguments = parser.parse_args()
    try:
        model = fit([MotionFolder(root, frames_per_second=30).takes() for root in arguments.roots])
    except InputError as error:
        sys.exit(str(error))
    model.save(arguments.output)
    print(
        f"{arguments.output}: {len(model.components)} components; stride time varies by "
        f"{model.variation.stride_time:.1%}, amplitude by {model.variation.amplitude:.1%}, "
        f"posture by {model.variation.posture.mean():.2f} degrees on average"
    )


def fit(folders: Iterable[Iterable[Motion]]) -> WalkerModel:
    """Fit the model to the steady walking in some takes.

    Parameters
    ----------
    folders : iterable of iterable of Motion
        Takes by the folder they come from. Differences between the mean postures of folders are
        mostly conventions of their skeletons (how collars, elbows and wrists share a hanging
        arm's rotation) rather than of their people, and do not count as variation.

    Returns
    -------
    model : WalkerModel

    Raises
    ------
    InputError
        If fewer than two pieces of walking are in the takes.
    """
    rows: list[Array] = []
    groups: list[tuple[int, str]] = []
    stretches: list[Steps] = []
    for folder, takes in enumerate(folders):
        for take in takes:
            for steps in steady_steps(take):
                stretches.append(steps)
                for piece in pieces(steps):
                    mean, harmonics = fit_harmonics(piece)
                    for walk in ((mean, harmonics), mirrored_gait(mean, harmonics)):
                        rows.append(pack(*walk, piece.cadence))
                        groups.append((folder, take.performer))
    if len(rows) < 4:
        raise InputError(
            "the takes hold fewer than two pieces of steady walking; give folders of walks that "
            "last two strides or more"
        )
    coefficients, weights = np.array(rows), _equal_performers(groups)
    posture = slice(0, len(ANGLES))
    coefficients[:, posture] = _align_folders(
        coefficients[:, posture], weights, np.array([folder for folder, _ in groups])
    )
    mean, components = principal_components(coefficients, weights)
    return WalkerModel(mean, components, measure_variation(stretches))


def _equal_performers(groups: list[tuple[int, str]]) -> Array:
    """Weights of rows, which sum to 1 and are the same in total for every performer."""
    counts = Counter(groups)
    return np.array([1.0 / (len(counts) * counts[group]) for group in groups])


def _align_folders(postures: Array, weights: Array, folder: NDArray[np.int_]) -> Array:
    """Shift each folder's mean posture to the mean of all."""
    aligned = postures.copy()
    for f in np.unique(folder):
        own = folder == f
        aligned[own] -= np.average(postures[own], axis=0, weights=weights[own])
    return aligned + weights @ postures


def pieces(steps: Steps) -> list[Steps]:
    """Cut a stretch into equal pieces of about four strides."""
    count = max(1, round(steps.strides / STRIDES))
    bounds = np.linspace(steps.phase[0], steps.phase[-1] + 1e-9, count + 1)
    return [steps.part(a, b) for a, b in pairwise(bounds)]


def principal_components(rows: Array, weights: Array) -> tuple[Array, Array]:
    """Weighted principal components.

    Parameters
    ----------
    rows : ndarray, shape (n, C)
    weights : ndarray, shape (n,)
        Sum to 1.

    Returns
    -------
    mean : ndarray, shape (C,)
    components : ndarray, shape (K, C)
        Each of the length of its standard deviation; they explain `VARIANCE`.
    """
    mean = weights @ rows
    _, lengths, directions = np.linalg.svd(
        np.sqrt(weights)[:, None] * (rows - mean), full_matrices=False
    )
    share = np.cumsum(lengths**2) / np.sum(lengths**2)
    kept = int(np.searchsorted(share, VARIANCE)) + 1
    return mean, lengths[:kept, None] * directions[:kept]


def measure_variation(stretches: list[Steps]) -> Variation:
    """Measure the variation between neighbouring strides, in stretches of three or more.

    Parameters
    ----------
    stretches : list of Steps

    Returns
    -------
    variation : Variation
        Medians over the stretches; zero if none is long enough.
    """
    found = [_stretch_variation(s) for s in stretches if s.strides >= 3]
    if not found:
        return Variation()
    times, amplitudes, postures = zip(*found, strict=True)
    return Variation(
        float(np.median(times)), float(np.median(amplitudes)), np.median(postures, axis=0)
    )


def _stretch_variation(steps: Steps) -> tuple[float, float, Array]:
    starts = steps.phase[0] + 2 * np.pi * np.arange(int(steps.strides) + 1)
    singles = [steps.part(a, b) for a, b in pairwise(starts)]
    durations = np.diff(np.interp(starts, steps.phase, steps.seconds))
    fits = [fit_harmonics(single) for single in singles]
    typical = fit_harmonics(steps)[1]
    amplitudes = [np.sum(h * typical) / np.sum(typical**2) for _, h in fits]
    # Differences of neighbours: slow changes of pace or of the path's curve are no variation.
    return (
        float(_neighbour_sd(durations) / durations.mean()),
        float(_neighbour_sd(np.array(amplitudes))),
        _neighbour_sd(np.array([mean for mean, _ in fits])),
    )


def _neighbour_sd(values: Array) -> Array:
    return np.sqrt(np.mean(np.diff(values, axis=0) ** 2, axis=0) / 2)


if __name__ == "__main__":
    main()

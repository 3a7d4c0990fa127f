from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.recording import InfluentialExamples
from silpose.silhouette import Camera


def regressor(rows, coef):
    return SimpleNamespace(basis_=SimpleNamespace(indices_=np.array(rows)), coef_=coef)


@pytest.fixture
def coef():
    """Coefficients of six relevance vectors, the k-th k + 1 times as large, and a constant."""
    return np.vstack([np.outer(np.arange(1, 7), np.ones(55)), np.full(55, 99.0)])


def found(sequences, rows, coef, camera, activations=None):
    details = SimpleNamespace(activations=np.ones((3, 7)) if activations is None else activations)
    return InfluentialExamples.of(regressor(rows, coef), details, sequences, camera, ANGLES)


def test_weight_is_activation_times_size_of_coefficients(sequence, camera, coef):
    activations = np.ones((3, 7))
    activations[1, 0] = 30
    examples = found([sequence], [0, 3, 5, 7, 9, 11], coef, camera, activations)
    assert examples.chosen[0].tolist() == [5, 4, 3, 2, 1]
    assert examples.weight[0] == pytest.approx(np.arange(6, 1, -1) / 21)
    assert examples.chosen[1, 0] == 0
    assert examples.weight[1, 0] == pytest.approx(30 / 50)


def test_too_few_relevance_vectors_explain_nothing(sequence, camera, coef):
    assert found([sequence], [0, 3], coef, camera) is None


def test_each_take_is_projected_by_its_own_camera(sequence, camera, coef):
    """A take without a camera is drawn by the default one, whatever came before it."""
    near = Camera(width=96, height=96, distance=camera.distance / 2)
    plain = replace(sequence, name="plain", camera=None)
    own = replace(sequence, name="own", camera=near)
    rows = [0, 2, 4]
    both = [*rows, *(len(sequence) + row for row in rows)]
    drawn = found([own, plain], both, coef, camera).bones
    assert drawn[3:] == pytest.approx(found([plain, own], both, coef, camera).bones[:3])
    assert np.abs(drawn[:3] - drawn[3:]).max() > 1  # pixels


def test_outlines_are_those_of_the_masks(sequence, camera, coef):
    examples = found([replace(sequence, camera=camera)], [0, 3, 5, 7, 9, 11], coef, camera)
    scale = 200 / camera.height
    for outlines, row in zip(examples.outlines, [0, 3, 5, 7, 9, 11], strict=True):
        rows = np.flatnonzero(sequence.masks[row].any(axis=1))
        every = np.concatenate(outlines)
        assert every[:, 1].min() == pytest.approx(scale * rows[0])
        assert every[:, 1].max() == pytest.approx(scale * rows[-1])


def test_without_masks_poses_alone_are_drawn(sequence, camera, coef):
    take = replace(sequence, masks=None, z=np.ones((len(sequence), 100)))
    examples = found([take], [0, 3, 5, 7, 9, 11], coef, camera)
    assert examples.outlines == [[]] * 6
    assert examples.bones.shape == (6, len(ANGLES.bones), 2, 2)

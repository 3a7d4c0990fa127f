import numpy as np
import pytest

from silpose.tracking import silhouette_regressor
from silpose.tracking.distances import squared_distances
from silpose.tracking.silhouette_regressor import SilhouetteRegressor


def fitted(distances, poses):
    return SilhouetteRegressor.of(SilhouetteRegressor.moments(distances, poses))


@pytest.fixture
def curve():
    """Where on a curve examples are (200,), their descriptors (200, 2) and poses (200, 3)."""
    where = np.linspace(0, 5, 200)
    poses = np.stack([np.sin(where), where, np.cos(2 * where)], axis=1)
    return where, np.stack([where, np.sqrt(where)], axis=1), poses


def test_regresses_what_it_has_not_seen(curve):
    _, z, poses = curve
    distances = squared_distances(z, z[::10]) / 0.3
    alone = fitted(distances[::2], poses[::2])
    off = np.abs(alone.predict(distances[1::2]) - poses[1::2])
    assert off.mean() < 0.02 * poses.std()


def test_averages_poses_that_look_alike(curve):
    _, z, poses = curve
    distances = squared_distances(z, z[::10])
    both = fitted(np.vstack([distances] * 2), np.vstack([poses, -poses]))
    assert both.predict(distances) == pytest.approx(np.zeros(poses.shape), abs=1e-6)


def test_confidence_is_low_far_from_all_key_poses(curve):
    _, z, poses = curve
    alone = fitted(squared_distances(z, z[::10]), poses)
    near, far = alone.confidence(np.array([[0.0, 9.0], [40.0, 50.0]]))[:, 0]
    assert near == pytest.approx(1)
    assert far < 1e-4


def test_of_very_many_key_poses_some_are_centres(curve, monkeypatch):
    monkeypatch.setattr(silhouette_regressor, "FEW", 20)
    _, z, poses = curve
    distances = squared_distances(z, z) / 0.3
    alone = fitted(distances[:, silhouette_regressor.centres_among(200)], poses)
    assert alone.slopes.shape == (20, 3)
    assert np.abs(alone.predict(distances) - poses).mean() < 0.02 * poses.std()

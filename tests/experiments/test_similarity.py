import numpy as np
import pytest


@pytest.fixture(scope="module")
def similarity(run, walkers):
    return run("similarity", walkers)


def test_descriptors_are_similar_where_poses_are(similarity):
    plain = similarity.metrics["descriptors"]
    roots = similarity.metrics["descriptors, Hellinger"]
    for values in (plain, roots):
        assert values["rank_correlation"] > 0.1
        assert values["rank_correlation_joints"] > 0.1
        assert values["nearest_pairs"] < 0.1  # 0.5 is chance
    assert roots["rank_correlation"] > plain["rank_correlation"]


def test_the_figure_shows_every_pair_of_frames_on_one_scale(similarity):
    images = [axes.images[0].get_array() for axes in similarity.result.figure.axes[:3]]
    for image in images:
        assert image.shape == (45, 45)
        np.testing.assert_array_equal(np.diag(image), 1)
        np.testing.assert_array_equal(image, image.T)
    assert [row["frames"] for row in similarity.rows] == [45, 45]


def test_the_first_take_that_matches_is_compared(run, walkers):
    name = walkers.load().train[1].name
    chosen = run("similarity", walkers, record=False, takes=["no_such", name, "*"])
    assert f"take '{name}' of" in chosen.result.recording.words


def test_similarity_of_the_very_walk_of_the_figure(run, authors):
    ran = run("similarity", authors)
    assert {row["frames"] for row in ran.rows} == {483}
    for values in ran.metrics.values():
        assert values["rank_correlation"] > 0.25
        assert values["nearest_pairs"] < 0.35

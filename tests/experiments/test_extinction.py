import pytest

from silpose.core.errors import InputError


@pytest.fixture(scope="module")
def extinction(run, walkers):
    return run("extinction", walkers, kernels=60)


def test_a_narrow_pose_kernel_goes_extinct(extinction):
    extinct = extinction.values("extinct")
    assert list(extinct) == ["as chosen", "3 times narrower", "10 times narrower"]
    assert extinct["as chosen"] < extinct["10 times narrower"]


def test_the_figure_shows_every_kernel_at_every_frame(extinction):
    images = [axes.images[0] for axes in extinction.result.figure.axes if axes.images]
    assert [image.get_array().shape for image in images] == 3 * [(60, 45)]


def test_widths_must_be_positive(run, walkers):
    with pytest.raises(InputError, match="narrower must be positive, not 0"):
        run("extinction", walkers, narrower=[3, 0])
    with pytest.raises(InputError, match="kernels must be a positive integer"):
        run("extinction", walkers, kernels=0)

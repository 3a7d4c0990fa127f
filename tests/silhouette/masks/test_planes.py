import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette.masks.picture import Picture
from silpose.silhouette.masks.planes import choose_plane

RED_ON_BLACK = np.uint8([[0, 0, 0], [200, 0, 0]])


def cut_out(mask):
    return Picture(np.dstack([np.full((*mask.shape, 3), 90, np.uint8), 255 * mask]), "a")


def test_alpha_is_taken_if_half_of_the_pictures_have_it(figures):
    opaque = Picture(figures[0], "b")
    plane = choose_plane([cut_out(figures[0]), opaque], "it")
    assert plane.name == "the alpha channel"
    np.testing.assert_array_equal(plane.of(cut_out(figures[1])), 255 * figures[1])
    assert (plane.of(opaque) == 255).all()
    plane = choose_plane([cut_out(figures[0]), opaque, opaque], "it")
    assert plane.name != "the alpha channel"


def test_alpha_that_hides_everything_is_no_mask(figures):
    grey = np.repeat(255 * figures[0][..., None], 3, axis=2)
    hidden = Picture(np.dstack([grey, 0 * figures[0]]), "a")
    plane = choose_plane([hidden], "it")
    np.testing.assert_array_equal(plane.of(hidden), 255 * figures[0])


def test_a_palette_of_greys_is_looked_up_and_one_of_colours_is_not(figures):
    grey = Picture(1 - figures[0], "a", np.uint8([[255] * 3, [0] * 3]))
    plane = choose_plane([grey], "it")
    np.testing.assert_array_equal(plane.of(grey), 255 * figures[0])
    np.testing.assert_array_equal(choose_plane([grey], "it", True).of(grey), 1 - figures[0])
    labels = Picture(figures[0], "a", RED_ON_BLACK)
    plane = choose_plane([labels], "it")
    assert plane.labels
    np.testing.assert_array_equal(plane.of(labels), figures[0])


@pytest.mark.parametrize("palette", [np.zeros((0, 3)), np.zeros((256, 3)), np.zeros((1, 3))])
def test_a_palette_without_colours_means_nothing(figures, palette):
    picture = Picture(figures[0], "a", palette.astype(np.uint8))
    np.testing.assert_array_equal(choose_plane([picture], "it").of(picture), figures[0])


def test_few_colours_are_numbered_and_blank_pictures_are_among_them(figures):
    colours = [Picture(RED_ON_BLACK[mask], str(k)) for k, mask in enumerate(figures)]
    blank = Picture(0 * figures[0], "blank")
    plane = choose_plane([*colours, blank], "it")
    assert plane.labels and "(200, 0, 0)" in plane.name
    np.testing.assert_array_equal(plane.of(colours[0]), figures[0])
    assert not plane.of(blank).any()


def test_many_colours_are_distances_from_the_background(figures):
    rng = np.random.default_rng(0)
    noisy = RED_ON_BLACK[figures[0]] + rng.integers(0, 9, (48, 40, 3), dtype=np.uint8)
    plane = choose_plane([Picture(noisy, "a")], "it")
    assert plane.colours
    np.testing.assert_array_equal(plane.of(Picture(noisy, "a")) > 100, figures[0] > 0)


def test_a_palette_and_colours_do_not_mix(figures, photo):
    with pytest.raises(InputError, match="'b' of it is in colours, others are indices"):
        choose_plane([Picture(figures[0], "a", RED_ON_BLACK), Picture(photo, "b")], "it")

import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette.masks.arrays import picture_of_item, pictures_of_array, pictures_of_items


def pixels(pictures):
    return [picture.pixels for picture in pictures]


@pytest.mark.parametrize(
    "shape",
    [
        lambda stack: stack,
        lambda stack: stack[:, None],
        lambda stack: stack[..., None],
        lambda stack: np.repeat(stack[..., None], 3, axis=3),
        lambda stack: np.repeat(stack[:, None], 3, axis=1),
        lambda stack: np.ma.masked_array(stack),
    ],
)
def test_any_order_of_axes_that_is_certain_is_read(figures, shape):
    stack = 255 * np.stack(figures)
    np.testing.assert_array_equal(pixels(pictures_of_array(shape(stack), "the array")), stack)


def test_one_mask_and_one_picture_in_colours_are_single(figures):
    assert len(pictures_of_array(figures[0], "the array")) == 1
    assert len(pictures_of_array(np.dstack([figures[0]] * 3), "the array")) == 1


@pytest.mark.parametrize("count", [6, 40, 48])
def test_a_stack_whose_frames_come_last_is_refused(figures, count):
    stack = np.stack([figures[k % 6] for k in range(count)], axis=-1)
    with pytest.raises(InputError, match=r"frames do not come first: give np\.moveaxis"):
        pictures_of_array(stack, "the array")


def test_objects_are_a_list(figures):
    held = np.empty(2, object)
    held[:] = [figures[0], figures[1][:30]]
    assert [p.shape for p in pixels(pictures_of_array(held, "the array"))] == [(48, 40), (30, 40)]


WRONG = {
    "is None: give an array of zeros": None,
    "holds <U1, no numbers": np.array([["a", "b"]]),
    "holds complex128, no numbers": np.ones((2, 2), complex),
    "no pixels": np.zeros((0, 5)),
    "values that are not finite: replace them": np.full((3, 3), np.nan),
    r"has the shape \(5,\)": np.zeros(5),
    r"has the shape \(2, 3, 4, 5\)": np.zeros((2, 3, 4, 5)),
    r"has the shape \(\)": b"bytes",
}


@pytest.mark.parametrize("message", WRONG)
def test_an_item_that_is_no_mask_is_named(message):
    with pytest.raises(InputError, match=f"frame 1 of the list .*({message})"):
        pictures_of_items([np.ones((3, 3)), WRONG[message]], "the list")


def test_a_tensor_that_cannot_be_an_array_is_named():
    class Tensor:
        def __array__(self, dtype=None, copy=None):
            raise TypeError("can't convert cuda:0 device type tensor to numpy")

    with pytest.raises(InputError, match=r"frame 3 of the stream is no array .*cuda"):
        picture_of_item(Tensor(), 3, "the stream")


@pytest.mark.parametrize("shape", [(0, 4, 4), (5,), (2, 2, 2, 2, 2)])
def test_shapes_that_are_no_masks_are_named(shape):
    with pytest.raises(InputError, match="the array has the shape"):
        pictures_of_array(np.zeros(shape), "the array")


def test_crops_that_touch_all_sides_are_no_stack_of_the_other_order(figures):
    crops = [mask[6:42, 12:23] for mask in figures]
    stack = np.stack([0 * crops[0], *crops, 0 * crops[0]])
    assert len(pictures_of_array(stack, "the array")) == 8

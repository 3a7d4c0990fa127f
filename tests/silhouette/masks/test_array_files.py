import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette.masks.array_files import read_array_file


def test_the_array_of_masks_is_found_by_its_name(tmp_path):
    masks, others = np.ones((2, 3, 4)), np.zeros(5)
    np.savez(tmp_path / "a.npz", masks=masks, x=others)
    np.savez(tmp_path / "b.npz", anything=masks)
    for name in ("a.npz", "b.npz"):
        np.testing.assert_array_equal(read_array_file(tmp_path / name), masks)
    np.savez(tmp_path / "c.npz", x=masks, y=others)  # the only one that can be a stack
    np.testing.assert_array_equal(read_array_file(tmp_path / "c.npz"), masks)
    np.savez(tmp_path / "d.npz", x=masks, y=masks)
    with pytest.raises(InputError, match=r"d\.npz' holds the arrays x, y: name the one .* 'masks'"):
        read_array_file(tmp_path / "d.npz")


def test_arrays_of_one_mask_each_are_frames_in_the_order_of_their_numbers(tmp_path):
    masks = np.random.default_rng(0).random((12, 3, 4)) < 0.5
    np.savez(tmp_path / "a.npz", *masks)
    np.savez(tmp_path / "b.npz", **{f"frame{k}": mask for k, mask in enumerate(masks)})
    for name in ("a.npz", "b.npz"):
        np.testing.assert_array_equal(read_array_file(tmp_path / name), masks)
    np.savez(tmp_path / "c.npz", masks[0], masks[0][1:])
    with pytest.raises(InputError, match=r"c\.npz' holds 2 masks of several sizes"):
        read_array_file(tmp_path / "c.npz")


def test_pickled_objects_are_refused(tmp_path):
    objects = np.array([np.ones((2, 2)), None], dtype=object)
    np.save(tmp_path / "a.npy", objects, allow_pickle=True)
    with pytest.raises(InputError, match="holds pickled objects"):
        read_array_file(tmp_path / "a.npy")


@pytest.mark.parametrize("name", ["a.npy", "a.npz"])
@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "is incomplete or damaged"),
        (b"text", "is no array of NumPy"),
        (b"PK\x03\x04 junk", "is incomplete or damaged"),
        (b"\x93NUMPY", "holds pickled objects"),
    ],
)
def test_damaged_files_are_named(tmp_path, name, content, said):
    (tmp_path / name).write_bytes(content)
    with pytest.raises(InputError, match=rf"{name}' {said}"):
        read_array_file(tmp_path / name)


def test_an_array_that_is_cut_off_is_named(tmp_path):
    np.save(tmp_path / "a.npy", np.ones((2, 3, 4)))
    whole = (tmp_path / "a.npy").read_bytes()
    np.testing.assert_array_equal(read_array_file(tmp_path / "a.npy"), np.ones((2, 3, 4)))
    (tmp_path / "a.npy").write_bytes(whole[:-8])
    with pytest.raises(InputError, match=r"damaged \(claims shape \(2, 3, 4\)"):
        read_array_file(tmp_path / "a.npy")


def test_the_only_array_and_one_of_a_usual_name_are_taken(tmp_path):
    mask, masks = np.ones((3, 4)), np.ones((2, 3, 4))
    np.savez(tmp_path / "a.npz", x=mask)
    np.savez(tmp_path / "b.npz", x=0 * masks, masks=masks)
    np.testing.assert_array_equal(read_array_file(tmp_path / "a.npz"), mask)
    np.testing.assert_array_equal(read_array_file(tmp_path / "b.npz"), masks)

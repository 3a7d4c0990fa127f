import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.regression import RidgeRegressor, file_blocks, split_rows, stored_blocks
from silpose.regression.blocks import read_block, read_rows


class Made:
    """A function that counts its calls in a file."""

    def __init__(self, folder, z, x):
        self.folder, self.z, self.x = folder, z, x

    def __call__(self):
        with (self.folder / "calls").open("a") as calls:
            calls.write(".")
        return self.z, self.x


def test_blocks_are_made_once_and_what_is_stored_is_not_made_again(smooth, tmp_path):
    (z, x), _ = smooth
    functions = [Made(tmp_path, *block) for block in split_rows(z, x, 50)]
    stored_blocks(functions[:2], tmp_path / "blocks", "walk")  # then it was stopped
    stored = stored_blocks(functions, tmp_path / "blocks", "walk")
    regressor = RidgeRegressor().fit_blocks(stored)
    assert (tmp_path / "calls").read_text() == "...."
    expected = RidgeRegressor().fit_blocks(split_rows(z, x, 50))
    np.testing.assert_array_equal(regressor.weights_, expected.weights_)

    with pytest.raises(InputError, match="blocks of other data: choose another folder"):
        stored_blocks(functions, tmp_path / "blocks", "run")
    with pytest.raises(InputError, match="holds other files"):
        stored_blocks(functions, tmp_path, "walk")


def test_a_folder_of_blocks_that_cannot_be_made_is_named(smooth, tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(InputError, match="cannot make the folder"):
        stored_blocks(split_rows(*smooth[0]), tmp_path / "file" / "blocks", "walk")


def test_rows_of_files_are_read_in_blocks(smooth, tmp_path):
    (z, x), _ = smooth
    np.save(tmp_path / "z.npy", z.astype(np.float32))
    np.save(tmp_path / "x.npy", x)
    blocks = file_blocks(tmp_path / "z.npy", tmp_path / "x.npy", 60)
    assert [(block.start, block.stop) for block in blocks] == [
        (0, 60), (60, 120), (120, 180), (180, 200),
    ]  # fmt: skip
    parts = [block() for block in blocks]
    assert np.concatenate([inputs for inputs, _ in parts]) == pytest.approx(z, rel=1e-6)
    assert np.array_equal(np.concatenate([outputs for _, outputs in parts]), x)
    assert {part.dtype for pair in parts for part in pair} == {np.dtype(float)}


def test_some_rows_are_gathered_from_the_blocks_that_have_them(smooth):
    (z, x), _ = smooth
    blocks = split_rows(z, x, 60)
    blocks[1] = None  # of which no row is wanted
    rows = np.array([3, 59, 120, 199])
    inputs, outputs = read_rows(blocks, np.array([0, 60, 120, 180]), rows)
    assert np.array_equal(inputs, z[rows])
    assert np.array_equal(outputs, x[rows])


@pytest.mark.parametrize(
    "wrong", [(np.ones((3, 2)), np.ones(3)), (np.ones((0, 2)), np.ones((0, 1)))]
)
def test_a_block_is_two_tables_with_rows(wrong):
    with pytest.raises(InputError, match="block 7 holds inputs and outputs of shapes"):
        read_block((7, lambda: wrong))

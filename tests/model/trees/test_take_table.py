import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.model import Poses
from silpose.model.trees.take_table import counts_in, counts_of, read_table, write_table
from silpose.silhouette.person import select_person


@pytest.fixture
def poses(sequence):
    """Ten poses, of which the last is not known and three are doubtful; one mask is cut."""
    masks = [mask[:, : 96 if k else 50] for k, mask in enumerate(sequence.masks[:10])]
    masks[9] = 0 * masks[9]
    x = sequence.x[:10].copy()
    x[9] = np.nan
    confidence = np.array([0.1] * 3 + [0.5] * 6 + [0.0])
    states = ["tracking"] * 8 + ["lost"] * 2
    facts = select_person(masks).facts
    return Poses(x, ANGLES, confidence, states, np.arange(10) / 15, facts=facts)


@pytest.mark.parametrize("suffix", [".csv", ".parquet"])
def test_counts_of_a_table_are_those_of_its_poses(poses, tmp_path, suffix):
    file = tmp_path / "a" / f"table{suffix}"
    write_table(file, poses, [f"{k}.png" for k in range(10)])
    assert counts_in(file) == counts_of(poses)
    assert counts_of(poses) == {
        "masks": 10, "blank": 1, "cut": 1, "doubtful": 3, "tracking": 8,
    }  # fmt: skip
    assert read_table(file)["file"][3] == "3.png"


def test_a_folder_that_cannot_be_made_is_named(poses, read_only):
    with pytest.raises(InputError, match="into=FOLDER"):
        write_table(read_only / "new" / "table.csv", poses, ["a"] * 10)

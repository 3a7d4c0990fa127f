import pytest

from silpose.core.errors import InputError
from silpose.silhouette.masks import read_masks
from silpose.silhouette.masks.other_formats import why_no_masks

FORMS = [
    ("a.pkl", "holds pickled objects"),
    ("a.zip", "is an archive: unpack it"),
    ("a.npy.gz", "is an archive: unpack it"),
    ("a.MAT", "is of MATLAB"),
    ("a.h5", "is of HDF5"),
    ("a.parquet", "is a table: read it by pandas"),
    ("a.heic", "is an image of a kind that is not read"),
    ("a.xml", "is XML"),
    ("a.txt", "is text"),
]


@pytest.mark.parametrize(("name", "message"), FORMS)
def test_what_is_not_read_is_named_with_what_to_do(tmp_path, name, message):
    below = tmp_path / "001" / "090"
    below.mkdir(parents=True)
    (below / name).write_bytes(b"some bytes")
    with pytest.raises(InputError, match=rf"{name}' {message}"):
        read_masks(below / name)
    with pytest.raises(InputError, match=rf"holds no masks; '.*{name}' {message}"):
        read_masks(tmp_path)


def test_of_a_folder_without_such_files_nothing_is_said(tmp_path):
    (tmp_path / "a.png").write_bytes(b"")
    assert why_no_masks(tmp_path) is None


def test_the_most_frequent_kind_is_named(tmp_path):
    for name in ("a.txt", "b.pkl", "c.pkl"):
        (tmp_path / name).write_bytes(b"")
    with pytest.raises(InputError, match=r"b\.pkl' holds pickled objects"):
        read_masks(tmp_path)

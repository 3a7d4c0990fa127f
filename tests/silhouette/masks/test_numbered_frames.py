import pytest

from silpose.silhouette.masks.numbered_frames import NumberedFrames


@pytest.mark.parametrize(
    ("names", "numbers"),
    [
        (["f1", "f2", "f5", "f6"], [0, 1, 4, 5]),
        (["0010", "0020", "0030", "0060", "0070"], [0, 1, 2, 5, 6]),
        (["cam1_-1", "cam1_0", "cam1_1", "cam1_3"], [0, 1, 2, 4]),
        (["1", "4", "5", "9", "12"], [0, 3, 4, 8, 11]),  # more than half left out
        (["cam1.0001", "cam1.0002", "cam1.0005"], [0, 1, 4]),
        (["cam1.8", "cam1.9", "cam1.10", "cam1.12"], [0, 1, 2, 4]),
        (["0.80", "0.84", "0.88", "1.00"], [0, 1, 2, 5]),  # seconds
        (["1690000000123", "1690000000157", "1690000000190"], [0, 1, 2]),  # milliseconds
        (["1690000000.033", "1690000000.066", "1690000000.100", "1690000001.033"], [0, 1, 2, 30]),
        (["1690000000123456788", "1690000000123456789", "1690000000123456791"], [0, 1, 3]),
        (["a1", "a2", "b1", "b2", "b9"], [0, 1, 2, 3, 4]),
        (["1_0", "1_1", "2_0", "2_1"], [0, 1, 2, 3]),
        (["1", "2", "02", "3"], [0, 1, 2, 3]),
        (["a", "b"], [0, 1]),
        (["1", "9"], [0, 1]),
        (["7"], [0]),
        ([], []),
    ],
)
def test_numbers_of_frames(names, numbers):
    files = [f"{name}.jp2" for name in names]
    assert NumberedFrames.of(files) == NumberedFrames(files, numbers)


@pytest.mark.parametrize("names", [["0.1", "0.25", "0.5"], ["id7", "id20", "id21", "id905"]])
def test_uneven_numbers_tell_no_times(names):
    files = [f"{name}.png" for name in names]
    numbered = NumberedFrames.of(files)
    assert numbered == NumberedFrames(files, list(range(len(names))), uneven=True)
    assert "masks in 'here' rise unevenly" in numbered.doubt("'here'", "masks")


def test_gaps_are_said():
    doubt = NumberedFrames(["a.png", "b.png", "c.png", "d.png"], [0, 1, 4, 6]).doubt("it", "masks")
    assert doubt.startswith("3 masks in it are missing by the numbers in their names, first after")
    assert "'b.png', and leave gaps in time" in doubt
    assert not NumberedFrames(["a", "b"], [0, 1]).doubt("it", "masks")

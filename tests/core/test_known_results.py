import errno
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from shutil import copyfile

import numpy as np
import pytest

from silpose.core import known_results
from silpose.core.errors import InputError
from silpose.core.known_results import KnownResults, described
from silpose.core.pose_space import ANGLES
from silpose.regression import Basis, Candidates, RidgeRegressor


class Counted:
    """A computation, and how often it was done."""

    def __init__(self, result):
        self.result, self.times = result, 0

    def __call__(self):
        self.times += 1
        return self.result


def test_what_was_computed_once_is_known(tmp_path):
    rows = Counted([{"method": "ridge", "width": np.float64(0.1), "nu": None, "error": 1 / 3}])
    known = KnownResults(tmp_path)
    first = known.recall(rows, "ridge", np.arange(3))
    assert known.recall(rows, "ridge", np.arange(3)) == first == rows.result
    assert rows.times == 1


def test_arrays_that_were_computed_once_are_known(tmp_path):
    arrays = Counted({"a": np.arange(3.0), "names": np.array(["x", "yz"])})
    known = KnownResults(tmp_path)
    for _ in range(2):
        own = known.recall_arrays(arrays, "odd masks")
        np.testing.assert_array_equal(own["a"], arrays.result["a"])
        assert own["names"].tolist() == ["x", "yz"]
    assert arrays.times == 1


def test_without_a_folder_nothing_is_remembered():
    rows = Counted([1])
    assert [KnownResults().recall(rows, "a") for _ in range(2)] == [[1], [1]]
    assert rows.times == 2


def same(z):
    return z


def other(z):
    return z


@pytest.mark.parametrize(
    ("one", "another"),
    [
        (np.arange(3.0), np.arange(3)),
        (np.arange(4.0), np.arange(4.0).reshape(2, 2)),
        (RidgeRegressor(), RidgeRegressor(damping=2.0)),
        (RidgeRegressor(Basis(width=1.0)), RidgeRegressor(Basis(width=2.0))),
        (Candidates(Basis(), {"width": [1.0]}), Candidates(Basis(), {"width": [1.0, 2.0]})),
        (partial(same, 1), partial(same, 2)),
        (partial(same, 1), partial(other, 1)),
        ({"a": None}, {"a": 0}),
        ([1, 2], [2, 1]),
        (ANGLES, "other"),
    ],
)
def test_whatever_changes_is_another_result(tmp_path, one, another):
    assert described(one) != described(another)
    known = KnownResults(tmp_path)
    assert known.recall(lambda: 1, one) == 1
    assert known.recall(lambda: 2, another) == 2
    assert known.depending_on("data").recall(lambda: 3, one) == 3


def test_what_was_fitted_does_not_count():
    z = np.random.default_rng(0).dirichlet(np.ones(4), 20)
    assert described(RidgeRegressor().fit(z, z)) == described(RidgeRegressor())


def test_other_code_has_other_results(tmp_path, monkeypatch):
    known = KnownResults(tmp_path)
    assert known.recall(lambda: 1, "a") == 1
    monkeypatch.setattr(known_results, "_code", lambda: "changed")
    assert known.recall(lambda: 2, "a") == 2


def test_what_cannot_be_described_is_computed_each_time(tmp_path):
    known, rows = KnownResults(tmp_path), Counted([1])
    for thing in (np.random.default_rng(0), lambda: None, object()):
        with pytest.raises(TypeError):
            described(thing)
        known.recall(rows, thing)
        known.depending_on(thing).recall(rows, "a")
    assert rows.times == 6
    assert not list(tmp_path.iterdir())


def put_folder(file):
    file.unlink()
    file.mkdir()


@pytest.mark.parametrize(
    ("spoil", "said"),
    [
        (lambda file: file.write_bytes(file.read_bytes()[:100]), "is damaged .* made anew"),
        (lambda file: file.write_bytes(file.read_bytes().replace(b"7", b"8")), "is damaged"),
        (lambda file: copyfile(file.with_name("other"), file), "holds another result"),
        (lambda file: np.savez(file, json=np.array("[8]")), "holds another result"),
        (put_folder, "goes on without it"),
    ],
    ids=["cut off", "a number changed", "another's", "without a name", "a folder"],
)
def test_a_damaged_file_is_named_and_made_anew(tmp_path, spoil, said):
    known = KnownResults(tmp_path)
    known.recall(lambda: [8], "b")
    (other,) = tmp_path.glob("*.npz")
    other.rename(tmp_path / "other")
    known.recall(lambda: [7], "a")
    (file,) = tmp_path.glob("*.npz")
    spoil(file)
    with pytest.warns(UserWarning, match=said):
        assert known.recall(lambda: [7], "a") == [7]
    if file.is_file():
        assert known.recall(lambda: None, "a") == [7]


def test_tables_of_the_package_are_its_code(tmp_path, monkeypatch):
    (tmp_path / "core").mkdir()
    words = tmp_path / "words.yaml"
    words.write_text("knee")
    monkeypatch.setattr(known_results, "__file__", str(tmp_path / "core/known_results.py"))
    before = known_results._code.__wrapped__()
    words.write_text("shin")
    assert known_results._code.__wrapped__() != before


def test_of_two_at_once_one_computes(tmp_path):
    rows = Counted([1])
    known = KnownResults(tmp_path)
    with ThreadPoolExecutor(4) as threads:
        assert list(threads.map(lambda _: known.recall(rows, "a"), range(8))) == [[1]] * 8
    assert rows.times == 1


def test_a_file_system_without_locks_is_named(tmp_path, monkeypatch):
    def acquire(_):
        raise NotImplementedError

    monkeypatch.setattr("silpose.core.one_builder.FileLock.acquire", acquire)
    with pytest.warns(UserWarning, match=r"it has no locks.*choose another dataset\.cache"):
        assert KnownResults(tmp_path).recall(lambda: 1, "a") == 1


def test_a_folder_that_cannot_be_made_is_named(tmp_path):
    (tmp_path / "file").write_text("")
    known = KnownResults(tmp_path / "file" / "cache")
    with pytest.warns(UserWarning, match=r"is not kept; choose another dataset\.cache") as told:
        assert [known.recall(lambda: 1, name) for name in "abc"] == [1, 1, 1]
    assert len(told) == 1


def test_where_a_disk_is_full_the_result_is_there_and_not_kept(tmp_path, monkeypatch):
    def full(*_, **__):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr("numpy.savez", full)
    known = KnownResults(tmp_path)
    with pytest.warns(UserWarning, match=r"No space left.*goes on without it"):
        assert known.recall(lambda: [1], "a") == [1]
    assert not list(tmp_path.glob("*.npz"))


@pytest.mark.parametrize("error", [InputError("no takes"), KeyboardInterrupt()])
def test_what_fails_while_it_is_computed_is_told(tmp_path, error):
    def compute():
        raise error

    with pytest.raises(type(error)):
        KnownResults(tmp_path).recall(compute, "a")
    assert not list(tmp_path.glob("*.npz"))

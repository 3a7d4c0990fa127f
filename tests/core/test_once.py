import threading
from concurrent.futures import ThreadPoolExecutor

import pytest

from silpose.core.once import Once


def test_threads_share_one_computation():
    computed, together, once = [], threading.Barrier(4), Once()

    def ask(key):
        together.wait()
        return once.get(key, lambda: computed.append(key) or [key])

    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(ask, "abab"))
    assert sorted(computed) == ["a", "b"]
    assert found == [["a"], ["b"], ["a"], ["b"]]
    assert found[0] is found[2]


def test_an_error_reaches_everyone_who_asks():
    once = Once()
    for _ in range(2):
        with pytest.raises(ZeroDivisionError):
            once.get("a", lambda: 1 / 0)

import time

import pytest

from silpose.core.stages import stage, timed, timing


def test_seconds_of_a_stage_add_up():
    with timing() as seconds:
        for _ in range(2):
            with stage("masks"):
                time.sleep(0.01)
    assert list(seconds) == ["masks"]
    assert 0.02 <= seconds["masks"] < 1


def test_the_outermost_stage_counts():
    @timed("inner")
    def work(a, b=1):
        time.sleep(0.01)
        return a + b

    with timing() as seconds:
        with stage("outer"):
            assert work(2, b=3) == 5
        assert list(seconds) == ["outer"]
        work(1)
    assert list(seconds) == ["outer", "inner"]
    assert seconds["outer"] >= 0.01


def test_a_stage_that_fails_is_timed_and_over():
    with timing() as seconds:
        with pytest.raises(ValueError, match="why"), stage("first"):
            raise ValueError("why")
        with stage("second"):
            pass
    assert list(seconds) == ["first", "second"]


def test_without_timing_nothing_is_kept():
    with stage("alone"):
        pass
    with timing() as seconds:
        pass
    assert seconds == {}

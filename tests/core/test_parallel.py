import contextlib
import os
import subprocess
import sys
import threading

import numpy as np
import pytest
from joblib import parallel_config
from threadpoolctl import threadpool_info, threadpool_limits

from silpose.core.errors import InputError
from silpose.core.parallel import (
    one_worker,
    parallel_map,
    parallel_stream,
    thread_map,
)

WAYS = [(None, "processes"), (2, "threads"), (2, "processes")]


def workers(n_jobs):
    """One after the other in this process, or several workers."""
    return contextlib.nullcontext() if n_jobs is None else parallel_config(n_jobs=n_jobs)


@pytest.mark.parametrize(("n_jobs", "prefer"), WAYS)
def test_outcomes_are_those_of_a_loop_in_order(n_jobs, prefer):
    matrices = [np.random.default_rng(seed).normal(size=(20, 20)) for seed in range(7)]

    def function(matrix):
        return np.linalg.svd(matrix)[1]

    with workers(n_jobs):
        outcomes = parallel_map(function, matrices, prefer=prefer)
    np.testing.assert_array_equal(outcomes, [function(matrix) for matrix in matrices])


@pytest.mark.parametrize(("n_jobs", "prefer"), WAYS)
def test_a_worker_has_one_thread_for_linear_algebra(n_jobs, prefer):
    def threads(_):
        np.ones((2, 2)) @ np.ones((2, 2))
        return [pool["num_threads"] for pool in threadpool_info() if pool["user_api"] == "blas"]

    with threadpool_limits(2), workers(n_jobs):
        before = threads(0)
        found = parallel_map(threads, range(4), prefer=prefer)
        assert threads(0) == before  # the caller's own limit is back
    assert all(count == 1 for counts in found for count in counts)
    assert all(found)


@pytest.mark.parametrize(("n_jobs", "prefer"), WAYS)
def test_exceptions_pass_through(n_jobs, prefer):
    def function(item):
        if item == 3:
            raise KeyError("the third")
        return item

    with workers(n_jobs), pytest.raises(KeyError, match="the third"):
        parallel_map(function, range(5), prefer=prefer)


@pytest.mark.parametrize("backend", ["loky", "threading", "sequential", "multiprocessing"])
def test_backends_of_joblib_work_or_are_refused(backend):
    with parallel_config(backend=backend, n_jobs=2):
        if backend == "multiprocessing":
            with pytest.raises(InputError, match=r"'multiprocessing' gives .*backend='loky'"):
                parallel_map(str, range(3))
        else:
            assert parallel_map(str, range(3)) == ["0", "1", "2"]


def test_processes_are_others_and_without_a_setting_there_are_none():
    def process(_):
        return os.getpid()

    assert set(parallel_map(process, range(3))) == {os.getpid()}
    with parallel_config(n_jobs=2):
        assert os.getpid() not in parallel_map(process, range(3))


@pytest.mark.parametrize("n_jobs", [1, 2, None, 50])
def test_threads_keep_the_order(n_jobs):
    assert thread_map(lambda k: k * k, 23, n_jobs) == [k * k for k in range(23)]
    assert thread_map(lambda k: k, 0, 2) == []


def test_one_thread_is_the_callers():
    assert set(thread_map(lambda _: threading.get_ident(), 3, 1)) == {threading.get_ident()}


@pytest.mark.parametrize("n_jobs", [None, 2])
def test_a_stream_gives_each_outcome_once(n_jobs):
    with workers(n_jobs):
        assert sorted(parallel_stream(abs, [-3, 1, -2])) == [1, 2, 3]


def test_threads_of_several_processes_do_not_compete():
    def threads(_):
        return {*thread_map(lambda _: threading.get_ident(), 50, 2)}

    with parallel_config(n_jobs=2):
        assert [len(found) for found in parallel_map(threads, range(2))] == [1, 1]
    assert len(threads(0)) >= 1


def test_one_worker_works_alone_whatever_is_asked_for():
    def where(_):
        threads = [p["num_threads"] for p in threadpool_info() if p["user_api"] == "blas"]
        return os.getpid(), threading.get_ident(), max(threads)

    alone = {(os.getpid(), threading.get_ident(), 1)}
    with threadpool_limits(2), workers(2):
        with one_worker():
            assert set(parallel_map(where, range(4))) == alone
            assert set(parallel_stream(where, range(4))) == alone
            assert set(thread_map(where, 4, n_jobs=2)) == alone
        assert os.getpid() not in {pid for pid, *_ in parallel_map(where, range(4))}


SPAWNING = """
import multiprocessing
import sys

import joblib
import numpy as np

import silpose
from silpose.core.errors import InputError
from silpose.core.parallel import parallel_map


def estimate(run):
    return silpose.load(run).explain_descriptors(np.full((2, 40), 0.1)).x


if __name__ == "__main__":
    multiprocessing.set_start_method("spawn")
    runs = [sys.argv[1]] * 3
    with joblib.parallel_config(n_jobs=2):
        there = parallel_map(estimate, runs)
    with multiprocessing.Pool(1) as pool:
        model = silpose.load(runs[0])
        sent = pool.apply(model.explain_descriptors, (np.full((2, 40), 0.1),)).x
    assert multiprocessing.get_start_method() == "spawn"
    assert all(np.array_equal(x, estimate(runs[0])) for x in [*there, sent])
"""


@pytest.mark.slow
def test_workers_that_are_spawned_give_the_same(finished, tmp_path):
    """As processes start on Windows and macOS: nothing is inherited, all is imported anew."""
    script = tmp_path / "script.py"
    script.write_text(SPAWNING)
    ran = subprocess.run(
        [sys.executable, str(script), str(finished.folder)], capture_output=True, text=True
    )
    assert ran.returncode == 0, ran.stderr

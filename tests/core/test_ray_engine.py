"""These run where Ray is installed (`silpose[ray]`), in an environment of its own if need be."""

import os
import signal
import socket
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.core.parallel import engine, one_worker, parallel_map, parallel_stream
from silpose.core.ray_engine import _check_answers
from silpose.regression import Basis, RelevanceVectorRegressor, RidgeRegressor, split_rows


def test_a_cluster_that_does_not_answer_is_named():
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        address = f"127.0.0.1:{free.getsockname()[1]}"
    with pytest.raises(InputError, match=f"no Ray cluster answers at '{address}'"):
        _check_answers(address)
    with pytest.raises(InputError, match="no Ray cluster answers"):
        _check_answers("nowhere")


def test_an_address_is_for_ray_and_an_engine_must_be_known():
    with pytest.raises(InputError, match="needs engine='ray'"), engine("joblib", address="host:1"):
        pass
    with pytest.raises(InputError, match="engine must be"), engine("spark"):
        pass


@pytest.fixture(scope="module")
def ray():
    if find_spec("ray") is None:
        pytest.skip("Ray is not installed")
    with engine("ray", n_jobs=2):  # before Ray is imported
        import ray

        yield ray


def where(_):
    return os.getpid()


class Dying:
    """A block whose first reader after the survey kills its own process."""

    def __init__(self, block, folder):
        self.block, self.folder, self.caller = block, folder, os.getpid()

    def __call__(self):
        reads = len(list(self.folder.iterdir()))
        (self.folder / str(reads)).touch()
        if reads == 1 and os.getpid() != self.caller:
            os.kill(os.getpid(), signal.SIGKILL)
        return self.block


def examples():
    rng = np.random.default_rng(0)
    z = rng.dirichlet(np.ones(8), 600)
    return z, np.stack([np.sin(6 * z[:, k]) + z[:, k + 1] ** 2 for k in range(5)], axis=1)


@pytest.mark.parametrize("regressor", [RidgeRegressor, RelevanceVectorRegressor])
def test_a_worker_killed_while_training_changes_nothing(ray, regressor, tmp_path):
    blocks = split_rows(*examples(), 100)
    with one_worker():
        expected = regressor(Basis(centres=100)).fit_blocks(blocks)
    blocks[3] = Dying(blocks[3], tmp_path)
    fitted = regressor(Basis(centres=100)).fit_blocks(blocks)
    assert len(list(tmp_path.iterdir())) > 2  # it was read again after the kill
    np.testing.assert_array_equal(fitted.relevance_, expected.relevance_)
    np.testing.assert_array_equal(fitted.weights_, expected.weights_)


def test_work_is_done_by_other_processes_in_order(ray):
    assert parallel_map(abs, [-3, 1, -2]) == [3, 1, 2]
    assert sorted(parallel_stream(abs, [-3, 1, -2])) == [1, 2, 3]
    assert os.getpid() not in parallel_map(where, range(6))


def always_dies(_):
    os.kill(os.getpid(), signal.SIGKILL)


def fails(_):
    raise KeyError("the third")


def test_a_piece_of_work_that_ends_every_worker_is_said(ray):
    with pytest.raises(InputError, match="ended its worker 4 times"):
        parallel_map(always_dies, range(1))
    with pytest.raises(KeyError, match="the third"):
        parallel_map(fails, range(1))
    assert parallel_map(abs, [-1]) == [1]


def test_ray_of_ours_listens_on_this_machine_alone(ray):
    listening = [line.split() for line in Path("/proc/net/tcp").read_text().splitlines()[1:]]
    nodes = ray.get_runtime_context().gcs_address
    assert nodes.startswith("127.0.0.1:")
    port = f"{int(nodes.rpartition(':')[2]):04X}"
    hosts = {entry[1].partition(":")[0] for entry in listening if entry[1].endswith(port)}
    assert hosts <= {"0100007F"}
    assert ray._private.worker._global_node.address_info["webui_url"] in ("", None)


def test_ray_is_not_started_twice(ray):
    with pytest.raises(InputError, match="in use in this process already"), engine("ray"):
        pass

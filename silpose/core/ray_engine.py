"""Independent pieces of work on Ray: on this machine, or on a cluster that runs.

A piece whose worker dies is done again elsewhere. Pickles cross to workers of our own only: Ray
that is started here listens on localhost, without a dashboard and without reports of its use.
"""

from __future__ import annotations

import os
import socket
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any, TypeVar

from silpose.core.errors import InputError

Item = TypeVar("Item")
Outcome = TypeVar("Outcome")

_RETRIES = 3  # of a piece of work whose worker died
_AHEAD = 2  # pieces of work that are under way for each worker
_PATIENCE = 5.0  # seconds until a cluster answers


class RayEngine:
    """Does pieces of work on a Ray that is connected.

    Parameters
    ----------
    workers : int
        Pieces that run at once.
    """

    def __init__(self, workers: int) -> None:
        import ray

        self._ray, self._workers = ray, workers

    def outcomes(
        self, function: Callable[[Item], Outcome], items: Sequence[Item], *, ordered: bool
    ) -> Iterator[Outcome]:
        """Yield the outcome of each item, in their order or as soon as it is there."""
        ray = self._ray
        shared = ray.put(function)  # once for all items: it may hold large arrays
        task = ray.remote(_apply).options(num_cpus=1, max_retries=_RETRIES)
        left = iter(items)
        running: list[Any] = []
        try:
            while True:
                while len(running) < _AHEAD * self._workers:
                    try:
                        running.append(task.remote(shared, next(left)))
                    except StopIteration:
                        break
                if not running:
                    return
                ready = running[0] if ordered else ray.wait(running, num_returns=1)[0][0]
                running.remove(ready)
                yield self._outcome(ready)
        finally:
            for pending in running:  # an error, or Ctrl-C: nobody waits for these
                ray.cancel(pending)  # by force, one that ends just then would end Ray 2.60

    def _outcome(self, reference: Any) -> Any:
        errors = self._ray.exceptions
        try:
            return self._ray.get(reference)
        except errors.RayTaskError as error:
            raise error.cause if isinstance(error.cause, Exception) else error from None
        except (errors.WorkerCrashedError, errors.OutOfMemoryError, errors.NodeDiedError) as error:
            raise InputError(
                f"a piece of work ended its worker {_RETRIES + 1} times "
                f"({type(error).__name__}), perhaps for want of memory: "
                "use a lower n_jobs, or smaller blocks"
            ) from error


@contextmanager
def ray_engine(n_jobs: int, address: str | None) -> Iterator[RayEngine]:
    """Connect to a Ray cluster, or start Ray on this machine; parameters as of `engine`."""
    prepare_environment(alone=address is None)
    import ray

    if ray.is_initialized():
        raise InputError("Ray is in use in this process already: leave that block first")
    more: dict[str, Any] = {"configure_logging": False, "log_to_driver": False}
    if address is None:
        more |= {"include_dashboard": False, "num_cpus": n_jobs if n_jobs > 0 else os.cpu_count()}
        more |= {"_node_ip_address": "127.0.0.1"}
    else:
        _check_answers(address)
    try:
        ray.init(address or "local", **more)
    except (ConnectionError, RuntimeError, ValueError) as error:
        raise InputError(f"cannot use Ray at {address or 'this machine'}: {error}") from error
    try:
        if address is None and not ray.get_runtime_context().gcs_address.startswith("127.0.0.1:"):
            raise InputError(
                "Ray was imported beforehand, and would listen beyond this machine: "
                "leave out 'import ray', or set RAY_ENABLE_WINDOWS_OR_OSX_CLUSTER=0 before it"
            )
        whole = int(ray.cluster_resources().get("CPU", 1))
        yield RayEngine(min(n_jobs, whole) if n_jobs > 0 else whole)
    finally:
        ray.shutdown()


def prepare_environment(*, alone: bool) -> None:
    """Tell Ray, before it is imported, to report to nobody and, alone, to listen on localhost."""
    os.environ["RAY_USAGE_STATS_ENABLED"] = "0"
    os.environ.setdefault("RAY_ACCEL_ENV_VAR_OVERRIDE_ON_ZERO", "0")  # else it warns
    os.environ.setdefault("RAY_task_oom_retries", str(_RETRIES))  # else it tries for ever
    if alone:
        # Else Ray listens on all addresses: `_node_ip_address` alone does not keep it from that.
        os.environ["RAY_ENABLE_WINDOWS_OR_OSX_CLUSTER"] = "0"


def _check_answers(address: str) -> None:
    host, _, port = address.rpartition(":")
    try:
        socket.create_connection((host, int(port)), _PATIENCE).close()
    except (OSError, ValueError, OverflowError) as error:
        raise InputError(
            f"no Ray cluster answers at '{address}': start one there by "
            "`ray start --head --port=6379` and give its HOST:6379, or leave the address out to "
            "start Ray on this machine"
        ) from error


def _apply(function: Callable[[Item], Outcome], item: Item) -> Outcome:
    return function(item)

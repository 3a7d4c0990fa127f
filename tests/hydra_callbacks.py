"""A callback of Hydra for tests: what its jobs returned, as a sweeper would see it."""

from typing import Any

from hydra.core.utils import JobReturn
from hydra.experimental.callback import Callback

RETURNED: list[Any] = []


class Returned(Callback):
    """Collects the return values of jobs."""

    def on_job_end(self, config: Any, job_return: JobReturn, **more: Any) -> None:
        RETURNED.append(job_return.return_value)

"""One run of a sweep: done once, whoever else does it and however often the sweep is started."""

from __future__ import annotations

import traceback
from collections.abc import Sequence
from contextlib import nullcontext, suppress
from pathlib import Path

from filelock import FileLock
from omegaconf import DictConfig, OmegaConf

from silpose.app.config import check_overrides
from silpose.app.failures import sentence
from silpose.app.paths import shorten_path
from silpose.app.sweep.run_name import run_name
from silpose.core.errors import InputError
from silpose.core.parallel import one_worker
from silpose.recording.runs.finished_run import load_run
from silpose.recording.runs.sweep_folder import (
    FAILURE,
    read_definition,
    write_failure,
)

_LOCKS = ".locks"


def run_in_sweep(settings: DictConfig, overrides: Sequence[str], alone: bool) -> float | None:
    """Run one job of a sweep, unless it is finished already; a failure is written, not raised.

    Parameters
    ----------
    settings : DictConfig
    overrides : sequence of str
        Those of the job, of which what the sweep varies makes its name.
    alone : bool
        Whether no other job runs beside it, so that it may use all processors.

    Returns
    -------
    headline : float or None
        None where there is none, or the run failed.
    """
    sweep = Path(settings.recording.root) / settings.experiment / settings.recording.sweep
    name = run_name(overrides, read_definition(sweep)["varied"])
    folder, lock = sweep / name, sweep / _LOCKS / f"{name}.lock"
    try:
        lock.parent.mkdir(exist_ok=True)
        with FileLock(lock):  # held by a process as long as it lives
            if (folder / "metrics.json").is_file():
                return load_run(folder).headline
            (folder / FAILURE).unlink(missing_ok=True)
            check_overrides(settings, overrides)
            OmegaConf.update(settings, "recording.name", name)
            from silpose.app.run import run_experiment  # heavy: only once there is something to do

            with nullcontext() if alone else one_worker():
                run = run_experiment(settings)
    except Exception as error:
        reason = sentence(error).removeprefix("silpose: ")
        with suppress(OSError, InputError):  # of a full disk nothing can be left there
            write_failure(folder, reason, traceback.format_exc())
        print(f"{name}  failed: {reason}", flush=True)
        return None
    took = f"{sum(run.seconds.values()):.1f} s"
    headline = "" if run.headline is None else f"{run.headline:.4g}"
    print(f"{name}  {headline}  {took}  {shorten_path(folder)}", flush=True)
    return run.headline

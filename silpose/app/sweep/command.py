"""A sweep from the command line to its table."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Sequence

from silpose.app.job import run_job
from silpose.app.sweep.engines import check_installed, settings_of_engines
from silpose.app.sweep.plan import plan_sweep
from silpose.app.sweep.report import report
from silpose.core.errors import InputError

_AGAIN = "the same command goes on where it stopped"


def is_sweep(options: Sequence[str], typed: Sequence[str]) -> bool:
    """Whether a command asks for several runs: by ``-m``, or by the name of a sweep."""
    if {"-m", "--multirun"} & set(options):
        return True
    return any(each.lstrip("+").split("=")[0] in ("sweep", "hydra.mode") for each in typed)


def run_sweep(options: Sequence[str], overrides: Sequence[str]) -> None:
    """Run a sweep, or what is left of it, and report all its runs.

    Parameters
    ----------
    options : sequence of str
        Hydra's, such as ``-m``.
    overrides : sequence of str
        As typed, with paths quoted.

    Raises
    ------
    InputError
        If it cannot be started; or, once all other runs are done and reported, if some failed.
    """
    check_installed(overrides)
    plan = plan_sweep(overrides)
    for doubt in plan.prepare():
        warnings.warn(doubt, stacklevel=2)
    sys.argv[1:] = [*options, *plan.overrides, *settings_of_engines(plan)]  # where Hydra reads them
    stopped: BaseException | None = None
    try:
        run_job()
    except (Exception, KeyboardInterrupt) as error:
        stopped = error
    done = report(plan)
    if isinstance(stopped, KeyboardInterrupt):
        raise InputError(f"interrupted: {_AGAIN}") from None
    if stopped is not None and done.failed == 0 and isinstance(stopped, InputError):
        raise stopped
    if stopped is not None and not (isinstance(stopped, ValueError) and done.failed):
        kind = type(stopped).__name__
        words = str(stopped).strip().split("\n")[0]
        raise InputError(f"the launcher stopped ({kind}: {words}): {_AGAIN}") from stopped
    if done.failed:
        raise InputError(
            f"{done.failed} of {done.failed + done.finished} runs failed, as listed above: "
            "the same command tries them again, and repeats no other"
        )
    if plan.runs is not None and done.finished < plan.runs:
        missing = plan.runs - done.finished
        raise InputError(f"{missing} of {plan.runs} runs left nothing behind: {_AGAIN}")

"""One run of an experiment, from settings to a folder of results."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Literal

from omegaconf import DictConfig, OmegaConf
from threadpoolctl import threadpool_limits

from silpose.app.build import build, prepare_call
from silpose.app.compose import build_components
from silpose.app.config import load, plain
from silpose.app.registry import ALTERNATIVES, COMPONENTS, experiment
from silpose.core.errors import InputError
from silpose.core.open_files import check_open_files
from silpose.core.parallel import check_engine, engine
from silpose.core.stages import timing
from silpose.experiments.catalogue import CATALOGUE, Entry
from silpose.recording import FinishedRun, load_run, write_result

_GROUPS = {name.partition(".")[0] for name in (*ALTERNATIVES, *COMPONENTS)}


@dataclass(frozen=True)
class RunOptions:
    """Settings of a run that belong to no group.

    Parameters
    ----------
    seed : int, default=0
        Seed of everything that is drawn, unless it is given one of its own.
    n_jobs : int, default=-1
        Number of workers side by side; -1 is one per processor.
    engine : {"local", "joblib", "ray"}, default="joblib"
        Where they are: no workers but this process, processes of this machine, or Ray.
    address : str or None, default=None
        ``HOST:PORT`` of a Ray cluster that runs; without it, Ray is started on this machine.
    debug : bool, default=False
        Whether an error shows where in the program it comes from.
    """

    seed: int = 0
    n_jobs: int = -1
    engine: Literal["local", "joblib", "ray"] = "joblib"
    address: str | None = None
    debug: bool = False

    def __post_init__(self) -> None:
        if self.n_jobs == 0:
            raise InputError("n_jobs must be an integer other than 0: -1 is one per processor")
        check_engine(self.engine, self.address)


def run_experiment(settings: Sequence[str] | DictConfig = ()) -> FinishedRun:
    """Run an experiment in a folder of its own.

    Parameters
    ----------
    settings : sequence of str, or DictConfig, default=()
        Overrides as on the command line, such as ``"experiment=tracking"``; or composed settings.

    Returns
    -------
    run : FinishedRun
        Read back from the folder; its `headline` is what a sweep minimises.

    Raises
    ------
    InputError
        If a setting is wrong, or its value does not fit the data.
    """
    if not isinstance(settings, DictConfig):
        _refuse_sweeps(settings)
        settings = load(settings)
    given = plain(settings)
    name = str(given.pop("experiment"))
    options = build("", {key: given.pop(key) for key in COMPONENTS[""].settings if key in given})
    own = {key: value for key, value in given.items() if key not in _GROUPS}
    components = build_components(settings)
    prepared = partial(prepare_call, experiment(name), "", own)
    prepared(components=components)  # refuses wrong settings before there is a folder
    check_open_files()
    text, defaults = (
        OmegaConf.to_yaml(each, resolve=True) for each in (settings, load([f"experiment={name}"]))
    )
    folder = build(
        "recording", given["recording"], experiment=name, settings=text, defaults=defaults,
        rows=CATALOGUE.get(name, Entry("")).rows,
    )  # fmt: skip
    with folder.claimed():  # outside of `try`: a folder that is another run's is left alone
        try:
            job = prepared(components=replace(components, run=folder))
            with (
                timing() as seconds,
                engine(options.engine, options.n_jobs, options.address),
                threadpool_limits(1),  # results must not depend on the number of processors
            ):
                result = job()
                write_result(folder, result, options.seed, seconds)
        except KeyboardInterrupt:
            folder.abandon(keep=False)
            raise
        except BaseException as error:
            kept = folder.abandon()
            words = f"'{folder.folder}' keeps {', '.join(kept)}"
            if kept and isinstance(error, InputError):
                raise InputError(f"{error}; {words}") from error
            if kept:
                error.add_note(words)
            raise
    return load_run(folder.folder)


def _refuse_sweeps(overrides: Sequence[str]) -> None:
    """Refuse overrides that ask for many runs, which only the command makes."""
    for override in overrides:
        if override.startswith(("sweep=", "hydra/", "hydra.")) or override in ("-m", "--multirun"):
            raise InputError(
                f"'{override}' is for sweeps, which the command makes: silpose -m …, or call this "
                "once for each run"
            )

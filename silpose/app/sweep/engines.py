"""Launchers and sweepers that are installed apart, and what each is told before it starts."""

from __future__ import annotations

from collections.abc import Sequence
from importlib.util import find_spec

from omegaconf import DictConfig

from silpose.app.sweep.plan import SweepPlan
from silpose.core.errors import InputError
from silpose.core.ray_engine import prepare_environment

_PLUGINS = {
    "hydra/launcher=joblib": ("joblib", "hydra_plugins.hydra_joblib_launcher"),
    "hydra/launcher=ray": ("ray", "hydra_plugins.hydra_ray_launcher"),
    "hydra/launcher=submitit_local": ("submitit", "hydra_plugins.hydra_submitit_launcher"),
    "hydra/launcher=submitit_slurm": ("submitit", "hydra_plugins.hydra_submitit_launcher"),
    "hydra/sweeper=optuna": ("optuna", "hydra_plugins.hydra_optuna_sweeper"),
}
_STUDY = "optuna.db"


def check_installed(overrides: Sequence[str]) -> None:
    """Refuse a launcher or sweeper that is not installed; the message names its extra."""
    for override in overrides:
        extra, module = _PLUGINS.get(override.lstrip("+"), ("", ""))
        if extra and not _is_there(module):
            raise InputError(f"{override} is not installed: pip install 'silpose[{extra}]'")


def settings_of_engines(plan: SweepPlan) -> list[str]:
    """Say what launcher and sweeper are told beside what was typed, as overrides."""
    launcher, sweeper = str(plan.launcher._target_), str(plan.sweeper._target_)
    own = _of_ray(plan.launcher.ray.init) if launcher.endswith(".RayLauncher") else []
    return own + (_of_optuna(plan) if sweeper.endswith(".OptunaSweeper") else [])


def runs_alone(launcher: DictConfig) -> bool:
    """Whether a launcher runs one job after the other, each of which may use all processors."""
    return str(launcher._target_).endswith(".BasicLauncher")


def _of_ray(init: DictConfig) -> list[str]:
    """Start Ray for this machine only, unless there is a cluster to join."""
    prepare_environment(alone=not init.get("address"))
    own: dict[str, object] = {"configure_logging": "false", "log_to_driver": "true"}
    if init.get("address"):
        own |= {"object_store_memory": "null"}  # which the cluster has given
    else:
        own |= {"include_dashboard": "false"}
    return [f"+hydra.launcher.ray.init.{k}={v}" for k, v in own.items() if k not in init]


def _of_optuna(plan: SweepPlan) -> list[str]:
    """Keep the study in the sweep's folder, and ask only for the trials that are still to come."""
    if len(plan.folders) > 1:
        raise InputError("Optuna minimises the headline of one experiment: name one only")
    import optuna  # which the sweeper needs, too

    optuna.logging.set_verbosity(optuna.logging.WARNING)
    storage = plan.sweeper.storage or f"sqlite:///{plan.folders[0] / _STUDY}"
    study = plan.sweeper.study_name or plan.name
    try:
        known = optuna.create_study(study_name=study, storage=storage, load_if_exists=True)
    except Exception as error:
        raise InputError(
            f"cannot keep the study in '{storage}' ({type(error).__name__}): pip install "
            "'sqlalchemy<2', or choose another hydra.sweeper.storage"
        ) from error
    done = len(known.get_trials(states=(optuna.trial.TrialState.COMPLETE,)))
    return [
        f"hydra.sweeper.storage='{storage}'",
        f"hydra.sweeper.study_name='{study}'",
        f"hydra.sweeper.n_trials={max(0, plan.sweeper.n_trials - done)}",
        "hydra.sweeper.max_failure_rate=1.0",  # failed runs are listed, and stop nothing
    ]


def _is_there(module: str) -> bool:
    try:
        return find_spec(module) is not None
    except ModuleNotFoundError:
        return False

import os
from types import SimpleNamespace

import pytest
from omegaconf import OmegaConf

from silpose.app.sweep import engines
from silpose.app.sweep.engines import check_installed, runs_alone, settings_of_engines
from silpose.core.errors import InputError

BASIC = OmegaConf.create({"_target_": "hydra._internal.core_plugins.BasicLauncher"})


def test_what_is_not_installed_is_named_with_its_extra(monkeypatch):
    monkeypatch.setattr(engines, "find_spec", lambda module: None)
    for override, extra in (
        ("hydra/launcher=joblib", "joblib"),
        ("hydra/launcher=submitit_slurm", "submitit"),
        ("hydra/sweeper=optuna", "optuna"),
    ):
        with pytest.raises(InputError, match=rf"{override} is not .*'silpose\[{extra}\]'"):
            check_installed(["seed=1,2", override])
    check_installed(["seed=1,2", "hydra/launcher=basic"])


@pytest.mark.parametrize("address", [None, "host:6379"])
def test_ray_is_for_this_machine_only_unless_there_is_a_cluster(address, monkeypatch):
    local = "RAY_ENABLE_WINDOWS_OR_OSX_CLUSTER"
    for name in ("RAY_USAGE_STATS_ENABLED", local):
        monkeypatch.setenv(name, "1")
    target = "hydra_plugins.hydra_ray_launcher.ray_launcher.RayLauncher"
    init = {"address": address}
    launcher = OmegaConf.create({"_target_": target, "ray": {"init": init}})
    plan = SimpleNamespace(launcher=launcher, sweeper=BASIC)
    own = {o.partition("init.")[2] for o in settings_of_engines(plan)}
    alone = {"include_dashboard=false"}
    assert own >= ({"object_store_memory=null"} if address else alone)
    assert not own & (alone if address else {"object_store_memory=null"})
    assert os.environ["RAY_USAGE_STATS_ENABLED"] == "0"
    assert os.environ[local] == ("1" if address else "0")  # 0: on localhost only
    assert not runs_alone(launcher)
    assert runs_alone(BASIC)

"""The schema that Hydra composes settings against: the parameters of all components.

Each file in ``conf/`` names its part of the schema in its defaults list, so that every parameter
of a component can be set, and nothing else.
"""

from __future__ import annotations

from functools import cache
from typing import Any

from hydra.core.config_store import ConfigStore
from omegaconf import DictConfig

from silpose.app.registry import ALTERNATIVES, COMPONENTS, Component, experiment
from silpose.app.signatures import Parameter
from silpose.experiments import EXPERIMENTS
from silpose.recording.runs.setting_differences import SEEDS

_OWN_FILES = ("silhouette.scenes",)  # parts that are chosen by themselves


@cache
def register() -> None:
    """Register the schema with Hydra, as configurations ``schema/…``."""
    store = ConfigStore.instance()
    for group, component in COMPONENTS.items():
        above, _, own = group.rpartition(".")
        if group == "":
            run = {name: _value(p) for name, p in component.settings.items()}
            store.store(group="schema", name="run", node=run)
        elif group in _OWN_FILES:
            store.store(group=f"schema/{above}", name=own, node=_node(component))
        elif not above and group not in ALTERNATIVES:
            parts = {
                name.removeprefix(f"{group}."): _node(part)
                for name, part in COMPONENTS.items()
                if name.startswith(f"{group}.") and name not in _OWN_FILES
            }
            store.store(group="schema", name=group, node={**_node(component), **parts})
    for group, alternatives in ALTERNATIVES.items():
        shared = _node(COMPONENTS[group]) if group in COMPONENTS else {}
        for kind, component in alternatives.items():
            node = {"kind": kind, **_node(component), **shared}
            store.store(group=f"schema/{group}", name=kind, node=node)
    for name in EXPERIMENTS:
        node = {"experiment": name, **_node(experiment(name))}
        store.store(group="schema/experiment", name=name, node=node)


def _node(component: Component) -> dict[str, Any]:
    return {
        name: "${seed}" if name in SEEDS else _value(parameter)
        for name, parameter in component.settings.items()
    }


def _value(parameter: Parameter) -> Any:
    if parameter.type.mapping:  # its keys are free
        return DictConfig(parameter.default or {}, flags={"struct": False})
    return parameter.default

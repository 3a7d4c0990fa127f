"""Every parameter of every component can be set, and its default stands once."""

from pathlib import Path

import pytest
import yaml

from silpose.app import build_components, load
from silpose.app.build import build, prepare_call
from silpose.app.conf_folder import config_folder
from silpose.app.config import plain
from silpose.app.registry import ALTERNATIVES, COMPONENTS, Component, experiment
from silpose.app.schema import SEEDS
from silpose.app.signatures import REQUIRED
from silpose.app.verbs import quoted
from silpose.experiments import EXPERIMENTS

FILES = {  # the choice that leads to each alternative
    ("motion", "walker"): ["motion=walker"],
    ("motion", "folder"): ["motion=bvh", "motion.root=somewhere"],
    ("dataset", "same_performer"): ["dataset=same_performer"],
    ("dataset", "cross_performer"): ["dataset=cross_performer"],
    ("dataset", "cross_camera"): ["dataset=cross_camera"],
    ("dataset", "agarwal"): ["dataset=agarwal", "dataset.path=somewhere"],
    ("descriptor", "shape_context"): ["descriptor=shape_context"],
}
OTHERS = {  # values of parameters that cannot have just any
    "descriptor.codebook_method": "random",
    "descriptor.normalisation": "mean",
    "engine": "local",
    "fitting.camera": "estimated",
    "fitting.shape": "estimated",
    "motion.formats": ["npz"],
    "motion.frame_rate": 120.0,
    "motion.joints": {"left_elbow": ["Ellbogen"]},
    "motion.performer": "(.)",
    "motion.up": "z",
    "recording.sinks": [],
    "regression.basis.choice": "kmeans",
    "regression.basis.kernel": "laplacian",
    "regression.mixture.point_estimate": "mean",
    "regression.rvm.prior": "component",
    "silhouette.blank": "nan",
    "silhouette.body.kind": "wooden",
    "silhouette.body.shape": [0.5] * 10,
    "silhouette.degradation.strength": [0.1, 0.2],
    "silhouette.degradation.test": ["holes"],
    "silhouette.degradation.train": ["holes"],
}


def components():
    """All components by group, each with the overrides that lead to it."""
    for group, component in COMPONENTS.items():
        yield group, component, []
    for group, alternatives in ALTERNATIVES.items():
        for kind, component in alternatives.items():
            yield group, component, FILES[group, kind]
    for name in EXPERIMENTS:
        yield "", experiment(name), [f"experiment={name}"]


PARAMETERS = [
    pytest.param(group, component, choice, parameter, id=f"{component.path}.{parameter.name}")
    for group, component, choice in components()
    for parameter in component.settings.values()
]


def other(parameter, full_name):
    """A valid value that is not the default."""
    kind, default = parameter.type, parameter.default
    if full_name in OTHERS:
        return OTHERS[full_name]
    if kind.mapping:
        return {"closing": [0.1]}
    if kind.items is not None:
        items = kind.items.scalars
        return [1.5, 2.5] if float in items else [3, 7] if int in items else ["other", "more"]
    if kind.scalars == (bool,):
        return not default
    if int in kind.scalars:
        return (default or 1) + 1
    if float in kind.scalars:
        return 0.9 * default if default and default not in kind.choices else 0.25
    return "another"


def typed(value):
    """A value as it is typed on the command line."""
    if isinstance(value, dict):
        return "{" + ",".join(f"{key}: {typed(item)}" for key, item in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ",".join(map(typed, value)) + "]"
    return quoted(value) if isinstance(value, str) else str(value).lower()


def found(group, built):
    """The part of the components that a group's settings made."""
    if group == "recording":
        return built
    parts = {
        "motion": "renderer.source",
        "silhouette": "masks",
        "silhouette.body": "renderer.body",
        "silhouette.camera": "renderer.camera",
        "silhouette.scenes": "renderer.scenes",
        "silhouette.degradation": "renderer.degradation",
    }
    for name in parts.get(group, group).split("."):
        built = getattr(built, name)
    return getattr(built, "estimator", built)


def same(value, wanted):
    if isinstance(value, tuple | list):
        return list(value) == wanted
    return str(value) == wanted if isinstance(value, Path) else value == wanted


@pytest.mark.parametrize(("group", "component", "choice", "parameter"), PARAMETERS)
def test_every_parameter_is_settable_and_arrives(
    group, component, choice, parameter, monkeypatch, tmp_path
):
    full_name = f"{group}.{parameter.name}".strip(".")
    value = other(parameter, full_name)
    settings = load([*choice, f"{full_name}={typed(value)}"])
    if group == "":
        own = {parameter.name: plain(settings)[parameter.name]}
        monkeypatch.setattr(Component, "load", lambda self: dict)
        required = {n: p for n, p in component.settings.items() if p.default == REQUIRED}
        given = {name: plain(settings)[name] for name in required} | own
        arrived = prepare_call(component, "", given)()[parameter.name]
        if parameter.type.mapping:  # its keys are added to those in conf/
            assert arrived.items() > value.items()
        else:
            assert arrived == value
    elif group == "recording":
        monkeypatch.chdir(tmp_path)
        folder = build(group, plain(settings)[group], experiment="any")
        arrived = {
            "root": folder.folder.parent.parent.name,
            "name": folder.folder.name,
            "sweep": folder.folder.parent.name,
            "sinks": list(folder.sinks.kinds),
            "viewer_port": folder.sinks.viewer_port,
            "web_port": folder.sinks.web_port,
            "keep_pictures": folder.keep_pictures,
        }
        assert arrived[parameter.name] == value
    elif group == "silhouette.video":
        _, given = build_components(settings).video.args  # it is built where a film is opened
        assert same(given[parameter.name], value)
    elif parameter.name == "cache":
        assert build_components(settings).known().folder.name == value
    else:
        assert same(getattr(found(group, build_components(settings)), parameter.name), value)


@pytest.mark.parametrize(
    "group", [group for group, component in COMPONENTS.items() if component.candidates]
)
def test_a_list_for_a_single_value_is_what_validation_chooses_from(group):
    name, parameter = next(
        (n, p) for n, p in COMPONENTS[group].settings.items() if {int, float} & {*p.type.scalars}
    )
    values = [0.3, 0.6] if float in parameter.type.scalars else [3, 6]
    candidates = build_components(load([f"{group}.{name}={values}"]))
    for part in group.split("."):
        candidates = getattr(candidates, part)
    assert candidates.grid[name] == values
    assert getattr(candidates.estimator, name) == parameter.default


def test_seeds_are_the_runs():
    seeded = build_components(load(["seed=7"]))
    assert seeded.renderer.source.seed == seeded.descriptor.random_state == 7
    assert seeded.regression.mixture.estimator.random_state == 7


def values_in(file):
    """Full names and values of the settings that a file of ``conf/`` gives, as written in it."""
    text = file.read_text()
    group = file.parent.relative_to(config_folder()).as_posix().replace("/", ".")
    prefix = "" if "@package _global_" in text else f"{group}."
    content = yaml.safe_load(text) or {}
    for name in ("defaults", "hydra"):  # which are no settings
        content.pop(name, None)

    def leaves(tree, above):
        for key, value in tree.items():
            if isinstance(value, dict) and f"{above}{key}" in groups:
                yield from leaves(value, f"{above}{key}.")
            else:
                yield f"{above}{key}", value

    groups = {*COMPONENTS, *ALTERNATIVES}
    return dict(leaves(content, prefix))


@pytest.mark.parametrize(
    "file", sorted(config_folder().glob("*/**/*.yaml")), ids=lambda file: file.stem
)
def test_no_file_repeats_a_default(file):
    group = file.parent.relative_to(config_folder()).as_posix()
    settings = load([f"{group}={file.stem}"])
    for name, value in values_in(file).items():
        above, _, last = name.rpartition(".")
        if above in ALTERNATIVES:
            component = ALTERNATIVES[above][settings[above].kind]
        else:
            component = COMPONENTS[above] if above else experiment(settings.experiment)
        parameter = component.settings[last]
        assert value != parameter.default, f"{file.name}: {name}"
        assert last not in SEEDS


def test_the_main_file_holds_no_settings():
    content = yaml.safe_load((config_folder() / "config.yaml").read_text())
    assert set(content) == {"defaults", "hydra"}


@pytest.mark.parametrize(
    ("component", "parameter"),
    [pytest.param(p.values[1], p.values[3], id=p.id) for p in PARAMETERS],
)
def test_every_setting_has_a_description(component, parameter):
    assert component.descriptions[parameter.name]

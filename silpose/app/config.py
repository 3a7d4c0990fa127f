"""Settings from ``conf/``, checked, and turned into the objects they describe.

Together with `silpose.app.main` the only place that knows Hydra.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from copy import deepcopy
from dataclasses import field, make_dataclass
from difflib import get_close_matches
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar, get_args, get_origin, get_type_hints

from hydra import compose, initialize_config_dir
from hydra.errors import HydraException, MissingConfigException
from omegaconf import MISSING, DictConfig, OmegaConf
from omegaconf.errors import OmegaConfBaseException

from silpose.core.errors import InputError

if TYPE_CHECKING:
    from silpose.experiments import Components

T = TypeVar("T")


def config_folder() -> Path:
    """Find ``conf/``: inside an installed package, or beside it in a checkout."""
    here = Path(__file__).resolve().parents[1]
    for folder in (here / "conf", here.parent / "conf"):
        if (folder / "config.yaml").is_file():
            return folder
    raise InputError(f"the settings folder 'conf' is missing beside '{here}': install silpose anew")


def load(overrides: Sequence[str] = ()) -> DictConfig:
    """Compose the settings, as the command line does.

    Parameters
    ----------
    overrides : sequence of str
        Such as ``"motion=bvh"`` or ``"regression.rvm.nu=3"``.

    Returns
    -------
    settings : DictConfig
    """
    try:
        with initialize_config_dir(str(config_folder()), version_base="1.3", job_name="silpose"):
            settings = compose("config", overrides=list(overrides))
    except HydraException as error:  # outside: to explain it, the settings are composed again
        raise InputError(explain(error)) from error
    check_overrides(settings, overrides)
    return settings


def explain(error: HydraException) -> str:
    """Say in one sentence what Hydra found wrong with the overrides."""
    message = str(error).strip()
    if isinstance(error, MissingConfigException) and error.options:
        group, _, choice = str(error.missing_cfg_file).rpartition("/")
        return f"there is no {group}={choice}{_nearest(choice, error.options)}"
    if key := re.match(r"(?:Could not override|Error merging override) '?([\w.]+)", message):
        known = list(_names(OmegaConf.to_container(load())))
        if key[1] not in known:
            return f"there is no setting '{key[1]}'{_nearest(key[1], known)}"
    if key := re.match(r"Error parsing override '(.*)'", message):
        return f"cannot read '{key[1]}': settings are given as key=value"
    return message.splitlines()[0]


def check_overrides(settings: DictConfig, overrides: Sequence[str]) -> None:
    """Refuse what ``+name=value`` adds: Hydra lets it pass, but nothing would read it."""
    for override in overrides:
        if override.startswith("+"):
            name = override.lstrip("+").split("=")[0]
            known = [n for n in _names(OmegaConf.to_container(settings)) if n != name]
            raise InputError(f"there is no setting '{name}'{_nearest(name, known)}")


def _names(tree: Any, prefix: str = "") -> Iterator[str]:
    if isinstance(tree, Mapping):
        for key, value in tree.items():
            yield f"{prefix}{key}"
            yield from _names(value, f"{prefix}{key}.")


def _nearest(name: str, known: Sequence[str]) -> str:
    group, dot, last = name.rpartition(".")
    beside = [k.rpartition(".")[2] for k in known if k.rpartition(".")[0] == group]
    if not beside:  # the group itself is misspelt
        group, dot, last, beside = "", "", name, list(known)
    if close := get_close_matches(last, beside, n=1):
        return f"; did you mean '{group}{dot}{close[0]}'?"
    return f"; there are {', '.join(sorted(beside))}"


def choose(choices: Mapping[str, Callable[..., T]], settings: Mapping[str, Any], where: str) -> T:
    """Build what ``settings["kind"]`` names among some choices."""
    kind = settings["kind"]
    if kind not in choices:
        raise InputError(f"there is no '{where}.kind={kind}'{_nearest(kind, list(choices))}")
    rest = {k: v for k, v in settings.items() if k != "kind"}
    return build(choices[kind], rest, where)


def build(
    constructor: Callable[..., T], settings: Mapping[str, Any], where: str, /, **given: object
) -> T:
    """Call a constructor with settings checked against its signature.

    Parameters
    ----------
    constructor : callable
        Its parameters' names and types are the schema.
    settings : mapping
    where : str
        Their group in ``conf/``, for messages; "" if they have none.
    **given
        Further arguments, which are no settings.
    """
    parameters = inspect.signature(constructor).parameters
    target = constructor.__init__ if inspect.isclass(constructor) else constructor  # type: ignore
    hints = get_type_hints(target) or get_type_hints(constructor)
    prefix = f"{where}." if where else ""
    values = {}
    for name, value in settings.items():
        if name not in parameters:
            raise InputError(
                f"there is no setting '{prefix}{name}'{_nearest(name, list(parameters))}"
            )
        values[name] = _typed(f"{prefix}{name}", _plain_hint(hints.get(name, Any)), value)
    missing = [
        f"{prefix}{name}"
        for name, p in parameters.items()
        if name not in given and values.get(name, p.default) in (p.empty, "???")
    ]
    if missing:
        raise InputError(f"'{missing[0]}' is not set: add {missing[0]}=…")
    return constructor(**values, **given)


def _typed(where: str, hint: Any, value: Any) -> Any:
    """Convert one value to the type that a parameter's annotation names."""
    schema = make_dataclass("Setting", [("value", hint, field(default=MISSING))])
    try:
        with_schema = OmegaConf.merge(OmegaConf.structured(schema), {"value": value})
        typed = OmegaConf.to_container(with_schema)
    except OmegaConfBaseException as error:
        raise InputError(f"'{where}' is to be {_in_words(hint)}, not {value!r}") from error
    assert isinstance(typed, dict)
    return typed["value"]


def _plain_hint(hint: Any) -> Any:
    """Reduce an annotation to what OmegaConf can check: numbers, text, lists of them, None."""
    arguments = get_args(hint)
    if get_origin(hint) is None:
        return hint if hint in (int, float, str, bool) else Any
    plain = [_plain_hint(a) for a in arguments if a is not type(None)]
    if get_origin(hint) in (list, Sequence):
        return list[plain[0]]  # type: ignore[valid-type]
    if len(plain) == 1 and type(None) in arguments:
        return plain[0] | None if plain[0] is not Any else Any
    return Any


def _in_words(hint: Any) -> str:
    if arguments := get_args(hint):
        words = [_in_words(a) for a in arguments]
        return f"a list like [{words[0]}, …]" if get_origin(hint) is list else " or ".join(words)
    words_of = {int: "a whole number", float: "a number", str: "text", bool: "true or false"}
    return words_of.get(hint, "null")


def build_components(settings: DictConfig) -> Components:
    """Build every room from its settings."""
    from silpose.dataset import (
        AgarwalFile,
        CrossCamera,
        CrossPerformer,
        Renderer,
        SamePerformer,
        SceneSampler,
    )
    from silpose.descriptor import ShapeContextHistogram
    from silpose.experiments import Components, DescriptorCache, OwnMasks
    from silpose.motion import MotionFolder, WalkerTakes
    from silpose.regression import (
        BasisSettings,
        Candidates,
        MixtureSettings,
        RidgeSettings,
        RvmSettings,
        SvmSettings,
    )
    from silpose.silhouette import Body, Camera, Degradation
    from silpose.tracking import (
        DynamicsSettings,
        HypothesesSettings,
        JointSettings,
        RivalSettings,
        TrackerSettings,
        TrackingSettings,
    )

    plain = OmegaConf.to_container(settings, resolve=True)
    assert isinstance(plain, dict)
    seed = _typed("seed", int, plain["seed"])
    silhouette, regression = plain["silhouette"], plain["regression"]
    keep = plain["dataset"].pop("keep", None)
    shown = deepcopy([plain[n] for n in ("motion", "silhouette", "dataset", "descriptor", "seed")])
    body, camera = silhouette.pop("body"), silhouette.pop("camera")
    scenes = build(SceneSampler, silhouette.pop("scenes"), "silhouette.scenes")
    parts = {
        "basis": BasisSettings,
        "ridge": RidgeSettings,
        "rvm": RvmSettings,
        "svm": SvmSettings,
        "mixture": MixtureSettings,
    }
    tracking = {
        "tracker": TrackerSettings,
        "dynamics": DynamicsSettings,
        "joint": JointSettings,
        "hypotheses": HypothesesSettings,
        "rivals": RivalSettings,
    }
    sources = {"walker": WalkerTakes, "folder": MotionFolder}
    rooms_camera = build(Camera, camera, "silhouette.camera")
    source = choose(sources, plain["motion"], "motion")
    rooms_body = build(Body, body, "silhouette.body")
    damage = build(Degradation, silhouette.pop("degradation"), "silhouette.degradation")
    datasets = {
        "same_performer": SamePerformer,
        "cross_performer": CrossPerformer,
        "cross_camera": CrossCamera,
        "agarwal": AgarwalFile,
    }
    chosen = choose(datasets, plain["dataset"], "dataset")
    name = f"{plain['dataset']['kind']}/{plain['motion']['kind']}"

    studio = None
    if not isinstance(chosen, AgarwalFile):
        studio = Renderer(source, chosen, rooms_body, rooms_camera, scenes, name, damage)
    shelf = None
    if keep is not None:
        files = source.files() if isinstance(source, MotionFolder) else []
        shelf = DescriptorCache.of(keep, shown, files)
    return Components(
        dataset=studio.dataset if studio else chosen.dataset,
        studio=studio,
        camera=rooms_camera,
        own_masks=build(OwnMasks, silhouette, "silhouette"),
        descriptor=choose(
            {"shape_context": ShapeContextHistogram}, plain["descriptor"], "descriptor"
        ),
        candidates=Candidates(
            **{n: build(kind, regression[n], f"regression.{n}") for n, kind in parts.items()}
        ),
        tracking=TrackingSettings(
            **{n: build(k, plain["tracking"][n], f"tracking.{n}") for n, k in tracking.items()}
        ),
        seed=seed,
        shelf=shelf,
    )

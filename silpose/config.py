"""Settings from ``conf/``, checked, and turned into the objects they describe.

Together with `silpose.app` the only place that knows Hydra.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field, make_dataclass
from difflib import get_close_matches
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar, get_args, get_origin, get_type_hints

from hydra import compose, initialize_config_dir
from omegaconf import MISSING, DictConfig, OmegaConf
from omegaconf.errors import OmegaConfBaseException

from silpose.errors import InputError

if TYPE_CHECKING:
    from silpose.experiments import Rooms

T = TypeVar("T")


def config_folder() -> Path:
    """Find ``conf/``: inside an installed package, or beside it in a checkout."""
    here = Path(__file__).resolve().parent
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
    with initialize_config_dir(str(config_folder()), version_base="1.3", job_name="silpose"):
        settings = compose("config", overrides=list(overrides))
    check_overrides(settings, overrides)
    return settings


def check_overrides(settings: DictConfig, overrides: Sequence[str]) -> None:
    """Refuse what ``+name=value`` adds: Hydra lets it pass, but nothing would read it."""
    for override in overrides:
        if override.startswith("+"):
            name = override.lstrip("+").split("=")[0]
            known = list(_names(OmegaConf.to_container(settings)))
            raise InputError(f"there is no setting '{name}'{_nearest(name, known)}")


def _names(tree: Any, prefix: str = "") -> Iterator[str]:
    if isinstance(tree, Mapping):
        for key, value in tree.items():
            yield f"{prefix}{key}"
            yield from _names(value, f"{prefix}{key}.")


def _nearest(name: str, known: Sequence[str]) -> str:
    close = get_close_matches(name, known, n=1, cutoff=0.4)
    return f"; did you mean '{close[0]}'?" if close else f"; there are {', '.join(sorted(known))}"


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
        Place of the settings in ``conf/``, for messages.
    **given
        Further arguments, which are no settings.
    """
    parameters = inspect.signature(constructor).parameters
    target = constructor.__init__ if inspect.isclass(constructor) else constructor  # type: ignore
    hints = get_type_hints(target) or get_type_hints(constructor)
    values = {}
    for name, value in settings.items():
        if name not in parameters:
            raise InputError(
                f"there is no setting '{where}.{name}'{_nearest(name, list(parameters))}"
            )
        values[name] = _typed(f"{where}.{name}", _plain_hint(hints.get(name, Any)), value)
    missing = [
        f"{where}.{name}"
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
        expected = getattr(hint, "__name__", None) or str(hint)
        raise InputError(f"'{where}' is to be {expected}, not {value!r}") from error
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


def furnish(settings: DictConfig) -> Rooms:
    """Build every room from its settings."""
    from silpose.dataset import SamePerformer
    from silpose.descriptor import ShapeContextHistogram
    from silpose.experiments.rooms import OwnMasks, Rooms
    from silpose.motion import BvhFolder, WalkerTakes
    from silpose.regression import BasisSettings, Candidates, RidgeSettings, RvmSettings
    from silpose.silhouette import Body, Camera

    plain = OmegaConf.to_container(settings, resolve=True)
    assert isinstance(plain, dict)
    silhouette, regression = plain["silhouette"], plain["regression"]
    body, camera = silhouette.pop("body"), silhouette.pop("camera")
    descriptors = {"shape_context": ShapeContextHistogram}
    parts = {"basis": BasisSettings, "ridge": RidgeSettings, "rvm": RvmSettings}
    sources = {"walker": WalkerTakes, "bvh": BvhFolder}
    return Rooms(
        source=choose(sources, plain["motion"], "motion"),
        body=build(Body, body, "silhouette.body"),
        camera=build(Camera, camera, "silhouette.camera"),
        own_masks=build(OwnMasks, silhouette, "silhouette"),
        splitter=choose({"same_performer": SamePerformer}, plain["dataset"], "dataset"),
        dataset_name=f"{plain['dataset']['kind']}/{plain['motion']['kind']}",
        descriptor=choose(
            {"shape_context": ShapeContextHistogram}, plain["descriptor"], "descriptor"
        ),
        candidates=Candidates(
            **{n: build(kind, regression[n], f"regression.{n}") for n, kind in parts.items()}
        ),
        seed=plain["seed"],
    )

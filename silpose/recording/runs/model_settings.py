"""Settings of a run that used a model which another run had trained."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import yaml

_TRAINED_BY = ("motion", "dataset", "descriptor", "regression", "tracking", "show")
_RENDERED_BY = ("body", "camera", "scenes", "degradation")  # of the group silhouette


def with_model_settings(settings: str, model: str | Path) -> str:
    """Put the settings that a model was trained with in place of a run's own, which nothing read.

    Parameters
    ----------
    settings : str
        Of the run, as YAML.
    model : path
        The ``.npz``, or its folder; the settings of its training are beside it, and where they
        are not, those of the run are left out.

    Returns
    -------
    settings : str
    """
    path = Path(model)
    file = (path if path.is_dir() else path.parent) / "config.yaml"
    own: dict[str, Any] = yaml.safe_load(settings) or {}
    trained: dict[str, Any] = {}
    if file.is_file():
        trained = yaml.safe_load(file.read_text(encoding="utf-8")) or {}
    kept = {name: value for name, value in own.items() if name not in _TRAINED_BY}
    kept |= {name: trained[name] for name in _TRAINED_BY if name in trained}
    for name in _RENDERED_BY:
        if isinstance(kept.get("silhouette"), dict):
            kept["silhouette"].pop(name, None)
            if name in trained.get("silhouette", {}):
                kept["silhouette"][name] = trained["silhouette"][name]
    text: str = yaml.safe_dump(kept, sort_keys=False, allow_unicode=True)
    return text

"""The experiments of the paper as parts: what each is run on, and with which settings."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from silpose.app.paper.options import PaperOptions
from silpose.app.suggestions import nearest
from silpose.core.errors import InputError

_FAST = (
    "silhouette.camera.width=96", "silhouette.camera.height=96", "descriptor.codebook_size=40",
    "regression.basis.width=[2]", "regression.ridge.damping=[0.1]", "regression.rvm.nu=[10]",
)  # fmt: skip
_FEW_CHOICES = (
    "choices.codebook_method=[random]", "choices.codebook_size=[20]", "choices.voters=[1]",
    "choices.vote_width=[]", "choices.radius=[]", "choices.edge_points=[]",
)  # fmt: skip
_FAST_WALKERS = ("motion.seconds=3", "motion.test_seconds=4")


@dataclass(frozen=True)
class Part:
    """One run.

    Attributes
    ----------
    experiment : str
    protocol : str, default=""
        What it is run on: ``walkers``, ``authors``.
    seed : int, default=0
    overrides : tuple of str, default=()
    on_authors : bool, default=False
        Whether the experiment runs on the authors' data, too, which have no masks.
    spread : bool, default=False
        Whether its errors are quoted with a spread over seeds.
    fast : tuple of str, default=()
        Further overrides of the fast pass.
    """

    experiment: str
    protocol: str = ""
    seed: int = 0
    overrides: tuple[str, ...] = ()
    on_authors: bool = False
    spread: bool = False
    fast: tuple[str, ...] = ()

    @property
    def name(self) -> str:
        """Name of its folder below that of the experiment."""
        return f"{self.protocol}_{self.seed}" if self.seed else self.protocol


PARTS = (
    Part("fitting", overrides=("hypotheses=false",)),
    Part("regressors", on_authors=True, fast=("kernels=[gaussian]", "widths=[1,2]")),
    Part("kernel_widths", fast=("factors=[0.5,1,2]",)),
    Part("hypotheses", on_authors=True),
    Part("damping", fast=("values=[0,0.9,1]",)),
    Part("initialisation"),
    Part("descriptor_robustness"),
    Part("descriptor_choices", fast=_FEW_CHOICES),
    Part("mixture", on_authors=True),
    Part("ambiguity"),
    Part("tracking", on_authors=True, spread=True),
    Part("single_image", on_authors=True, spread=True),
    Part("extinction"),
    Part("lookalikes"),
    Part("descriptor_space"),
    Part("similarity"),
    Part("parts"),
    Part("feature_selection"),
    Part("bridges"),
)  # fmt: skip
"""All experiments, the longest first, so that no worker is left with one at the end."""


def parts_of(options: PaperOptions) -> list[Part]:
    """All runs that the options ask for.

    Raises
    ------
    InputError
        If there is no such part.
    """
    known = [part.experiment for part in PARTS] + ["video"]
    for name in options.parts:
        if name not in known:
            raise InputError(f"paper.parts has no '{name}'{nearest(name, known)}")
    return [run for run in _all(options) if not options.parts or run.experiment in options.parts]


def _all(options: PaperOptions) -> Iterator[Part]:
    given = options.experiment_overrides
    protocol = next((o.partition("=")[2] for o in given if o.startswith("motion=")), "walkers")
    fast = (*_FAST, *(_FAST_WALKERS if protocol == "walkers" else ())) if options.fast else ()
    if options.video is not None:
        source = f"silhouette.source='{options.video}'"
        yield Part("video", "film", overrides=("silhouette=video", source))
    for part in PARTS:
        own = (*part.overrides, *fast, *(part.fast if options.fast else ()), *given)
        for seed in range(1 if options.fast or not part.spread else options.seeds):
            more = ("recording=none",) if seed else ()  # whose errors are quoted, and no more
            yield replace(part, protocol=protocol, seed=seed, overrides=(*own, *more))
        if part.on_authors and options.authors is not None:
            data = ("dataset=agarwal", f"dataset.path='{options.authors}'")
            yield replace(part, protocol="authors", overrides=data)

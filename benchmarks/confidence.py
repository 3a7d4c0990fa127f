"""Learn how sure a fit may be, and how well that holds: benchmarks/confidence.py [FOLDER] [--fast].

From the walkers and, where FOLDER holds captured motion as BVH, from that: takes are left out,
damaged, and mixed with what is no person. `Confidence`'s defaults were learned in this way, from
live fits as well.
"""

import sys
from itertools import pairwise

import numpy as np
from timing import FAST

from silpose.app.compose import build_components
from silpose.app.config import load
from silpose.experiments.setup import prepare, prepare_fitting
from silpose.fitting import EVIDENCE, Confidence
from silpose.model.fit_confidence_examples import confidence_examples

COUNT = 6 if FAST else 120  # pieces of takes, of six frames each
BINS = (0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0)


def examples(settings: list[str], rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Evidence and whether it is right, for one set of data."""
    components = build_components(load(["experiment=fitting", *settings]))
    described = prepare(components)
    ridge = described.choose_ridge(components.regression)
    return confidence_examples(prepare_fitting(components, described, ridge), COUNT, rng)[:2]


def table(confidence: Confidence, evidence: np.ndarray, right: np.ndarray) -> None:
    """How often poses are right, by how sure of them one is."""
    sure = confidence.of(evidence)
    for low, high in pairwise(BINS):
        own = (sure >= low) & (sure <= high)
        if own.any():
            print(f"{low:.1f} to {high:.1f}: {own.sum():5d} frames, {right[own].mean():.2f} right")


if __name__ == "__main__":
    rng = np.random.default_rng(0)
    data = {"walkers": examples([f"motion.seconds={4 if FAST else 12}"], rng)}
    for folder in [argument for argument in sys.argv[1:] if argument != "--fast"][:1]:
        captured = ["motion=bvh", f"motion.root={folder}", "dataset=cross_performer"]
        data["captured"] = examples([*captured, "silhouette.scenes.frames=4000"], rng)
    joined = [np.concatenate(part) for part in zip(*data.values(), strict=True)]
    learned = Confidence((0.0,) * (1 + len(EVIDENCE))).learned_from(*joined)
    for name, weight in zip(("constant", *EVIDENCE), learned.weights, strict=True):
        print(f"{name:>15}: {weight:.2f}")
    for name, own in data.items():
        others = [part for other, part in data.items() if other != name] or [own]
        other = [np.concatenate(part) for part in zip(*others, strict=True)]
        print(f"\n{name}, learned from the rest:")
        table(learned.learned_from(*other), *own)

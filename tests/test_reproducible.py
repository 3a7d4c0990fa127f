"""The same seed gives the same numbers, whatever the number of threads and workers."""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from silpose.core.array_files import read_npz

TOLERANCE = 1e-9  # of metrics, degrees and millimetres, between numbers of threads
SILPOSE = [sys.executable, "-m", "silpose.app.main"]


def run(root, name, fast, threads="", n_jobs=1):
    """Run the command in a process of its own; return its metrics, and the model's arrays."""
    settings = (f"recording.root={root}", f"recording.name={name}", f"n_jobs={n_jobs}")
    limits = {"OMP_NUM_THREADS": threads, "OPENBLAS_NUM_THREADS": threads}
    own = {key: value for key, value in limits.items() if value}
    subprocess.run([*SILPOSE, *fast, *settings, "recording=none"], check=True,
                   env=os.environ | own, capture_output=True)  # fmt: skip
    folder = Path(root) / "single_image" / name
    arrays = read_npz(folder / "model.npz")
    return json.loads((folder / "metrics.json").read_text())["metrics"], arrays


def flat(metrics, above=()):
    """Numbers of nested metrics, by their names."""
    for key, value in metrics.items():
        if isinstance(value, dict):
            yield from flat(value, (*above, key))
        elif isinstance(value, int | float):
            yield ".".join((*above, key)), float(value)


@pytest.mark.slow
def test_a_seed_gives_the_same_numbers_and_model(fast, tmp_path):
    metrics, model = run(tmp_path, "a", fast, threads="1")
    again, same_model = run(tmp_path, "b", fast, threads="1")
    assert again == metrics
    assert str(model["header"]) == str(same_model["header"])  # with the digest of all arrays
    two, other_model = run(tmp_path, "c", fast, threads="2", n_jobs=2)
    assert dict(flat(two)) == pytest.approx(dict(flat(metrics)), abs=TOLERANCE, nan_ok=True)
    assert set(other_model) == set(model)
    for name, array in model.items():
        if array.dtype.kind == "f":
            np.testing.assert_allclose(other_model[name], array, rtol=1e-6, atol=1e-9)

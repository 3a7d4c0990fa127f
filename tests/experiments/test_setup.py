import json
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.dataset.take import Dataset
from silpose.experiments import EXPERIMENTS
from silpose.experiments.setup import (
    fitter_of_model,
    prepare,
    prepare_fitting,
    prepare_tracking,
    renderer_of,
    tidy,
    want_masks,
)
from silpose.fitting import FittingOptions


def test_experiments_are_functions_of_their_modules_name():
    assert len(EXPERIMENTS) == 26
    for name, experiment in EXPERIMENTS.items():
        assert experiment.__name__ == name
        assert experiment.__module__ == f"silpose.experiments.{name}"
        assert experiment.__annotations__["return"] == "Result"
    with pytest.raises(KeyError):
        EXPERIMENTS["setup"]


def test_importing_the_table_imports_no_experiment():
    code = "import json, sys, silpose.experiments; print(json.dumps(sorted(sys.modules)))"
    loaded = json.loads(subprocess.check_output([sys.executable, "-c", code]))
    heavy = {"matplotlib", "sklearn", "cv2", "rerun", "mannequin", "silpose.model"}
    assert not heavy & set(loaded)


class Short:
    """A dataset whose test take is too short."""

    rendered = True

    def __init__(self, dataset):
        self.dataset = dataset

    def load(self, renderer):
        data = self.dataset.load(renderer)
        take = data.test[0]
        short = replace(take, x=take.x[:2], masks=take.masks[:2], offset=take.offset[:2])
        return Dataset(data.name, data.space, data.train, data.validation, [short])


def test_a_take_that_is_too_short_to_be_tracked_is_refused(walkers):
    with pytest.raises(InputError, match=r"test take '.+' of 2 frames is too short to be tracked"):
        prepare_tracking(replace(walkers, dataset=Short(walkers.dataset)))


def test_masks_and_rendered_motion_are_demanded_by_name(walkers, authors):
    want_masks(walkers.load().test, "some")
    assert renderer_of(walkers, "some") is walkers.renderer
    with pytest.raises(InputError, match=r"some needs masks.*dataset=same_performer"):
        want_masks(authors.load().test, "some")
    with pytest.raises(InputError, match=r"some renders motion.*dataset=same_performer"):
        renderer_of(authors, "some")


class WithoutMasks(Short):
    """A dataset that holds descriptors only."""

    def load(self, renderer):
        data = self.dataset.load(renderer)
        train = [replace(take, masks=None, z=np.zeros((len(take), 9))) for take in data.train]
        return Dataset(data.name, data.space, train, data.validation, data.test)


def test_a_fitter_is_trained_only_where_fitting_is_enabled(walkers):
    described = prepare(walkers)
    ridge = described.choose_ridge(walkers.regression)
    assert fitter_of_model(walkers, described, ridge) is None
    enabled = replace(walkers, fitting=FittingOptions(enabled=True, starts=3))
    assert fitter_of_model(enabled, described, ridge).starts == 3
    assert prepare_fitting(walkers, described, ridge).body is walkers.renderer.body
    with pytest.raises(InputError, match=r"fitting\.enabled=true needs masks"):
        prepare(replace(enabled, dataset=WithoutMasks(walkers.dataset)))


def test_metrics_become_rows():
    rows = tidy({"ridge": {"error": 1.0, "kept": 0.5}, "rvm": {"error": 2.0}})
    assert rows[1] == {"method": "ridge", "metric": "kept", "value": 0.5}
    assert len(rows) == 3

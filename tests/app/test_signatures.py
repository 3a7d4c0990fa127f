import subprocess
import sys

import pytest

from silpose.app.signatures import REQUIRED, descriptions, parameters


def test_a_constructor_is_read_as_python_reads_it():
    found = parameters("silpose.motion:MotionFolder")
    assert list(found)[:2] == ["root", "frames_per_second"]
    assert found["root"].default == REQUIRED
    assert found["root"].type.in_words() == "text"  # or a Path, which no setting can be
    assert found["formats"].default == ["bvh", "amc"]  # a list, as in YAML
    assert found["joints"].type.mapping  # behind a name for its type
    assert descriptions("silpose.motion:MotionFolder")["frames_per_second"]


def test_a_data_class_is_read_by_its_fields():
    found = parameters("silpose.dataset:SceneSampler")
    assert found["frames"].type.in_words() == "an integer or null"
    assert found["around"].default is False


def test_parameters_that_are_described_together_are_described_each():
    found = descriptions("silpose.descriptor:ShapeContextHistogram")
    assert found["angular_bins"]
    assert found["radial_bins"]


def test_what_is_no_plain_value_is_no_setting():
    assert not {"basis", "self", "units"} & set(parameters("silpose.regression:RidgeRegressor"))
    assert "shared" not in parameters("silpose.regression:MixtureOfRegressors")


def test_a_method_and_a_function_are_read_too():
    assert parameters("silpose.recording:RunFolder.start")["sinks"].default == ["file"]
    assert parameters("silpose.experiments.single_image:single_image")["show"].default == "rvm"


def test_an_unknown_name_is_an_error():
    with pytest.raises(LookupError):
        parameters("silpose.regression:Nothing")


def test_reading_imports_nothing_of_it():
    code = (
        "import sys; from silpose.app.signatures import parameters;"
        "parameters('silpose.regression:Basis');"
        "print({'numpy', 'sklearn', 'silpose.regression'} & set(sys.modules))"
    )
    shown = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert shown.stdout.strip() == "set()"

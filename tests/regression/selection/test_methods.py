import pytest

from silpose.core.errors import InputError
from silpose.regression import check_methods
from silpose.regression.selection.methods import share


@pytest.mark.parametrize("wrong", ["svn", "rvm_", "rvm_0", "rvm_101", "ridge_3"])
def test_a_wrong_name_is_refused(wrong):
    with pytest.raises(InputError, match=f"no method '{wrong}'; there are ridge, rvm, rvm_N"):
        check_methods(["ridge", wrong])


@pytest.mark.parametrize(
    ("method", "expected"),
    [("ridge", None), ("rvm", None), ("svm", None), ("rvm_6", 0.06), ("rvm_100", 1.0)],
)
def test_a_number_in_the_name_is_the_share_allowed(method, expected):
    assert share(method) == expected

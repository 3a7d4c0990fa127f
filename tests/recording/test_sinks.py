import pytest

from silpose.core.errors import InputError
from silpose.recording import Sinks


def test_sinks_that_do_not_exist_are_refused():
    with pytest.raises(InputError, match=r"recording\.sinks must list any of file, viewer, web"):
        Sinks(["file", "screen"], 9876, 9090)
    with pytest.raises(InputError, match=r"recording\.web_port must be a port"):
        Sinks(["web"], 9876, 70000)
    with pytest.raises(InputError, match=r"recording\.viewer_port must be a port"):
        Sinks(["viewer"], 0, 9090)

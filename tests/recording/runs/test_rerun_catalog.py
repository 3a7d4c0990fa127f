import socket

import pytest

from silpose.core.errors import InputError
from silpose.recording import catalog


def test_a_catalog_is_served_to_this_machine_only(finished):
    with catalog(finished.folder) as address:
        assert address.startswith("rerun+http://127.0.0.1:")
        port = int(address.rpartition(":")[2])
        with socket.socket() as probe:
            assert probe.connect_ex(("127.0.0.1", port)) == 0


def test_a_folder_without_recordings_is_named(tmp_path):
    with pytest.raises(InputError, match="there is no recording below"), catalog(tmp_path):
        pass


def test_a_port_in_use_is_named(finished):
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        port = other.getsockname()[1]
        with pytest.raises(InputError, match="--port"), catalog(finished.folder, port):
            pass

import argparse

import pytest

from silpose.app.served import RECORDINGS, catalog, catalog_options, serve_options
from silpose.core.errors import InputError


@pytest.mark.parametrize("options", [serve_options, catalog_options])
def test_the_folder_of_runs_need_not_be_given(options):
    parser = argparse.ArgumentParser()
    options(parser)
    assert parser.parse_args([]).folder == RECORDINGS


def test_a_catalog_needs_a_recording(tmp_path):
    given = argparse.Namespace(folder=tmp_path, port=0)
    with pytest.raises(InputError, match="no recording below"):
        catalog(given)

from dataclasses import replace

import pytest

import silpose
from silpose.core.errors import InputError
from silpose.recording.read import read_recording

pytest.importorskip("rerun_notebook")


@pytest.fixture(autouse=True)
def no_server(monkeypatch):
    """Without a browser, the viewer need not be served."""
    monkeypatch.setenv("RERUN_NOTEBOOK_ASSET", "http://127.0.0.1:9/widget.js")


def test_a_model_of_single_images_is_watched(finished, sequence, tmp_path):
    file = tmp_path / "watched.rrd"
    viewer = silpose.watch(finished.model, sequence, file=file)
    assert viewer.still["image/png"]
    assert {*read_recording(file).poses} == {"true", "estimated"}


def test_a_descriptor_is_watched_and_leaves_no_file(finished, sequence, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    silpose.watch(finished.model.descriptor, sequence, [sequence])
    assert not list(tmp_path.iterdir())


def test_masks_are_needed(finished, sequence):
    with pytest.raises(InputError, match="holds descriptors but no masks"):
        silpose.watch(finished.model, replace(sequence, masks=None))

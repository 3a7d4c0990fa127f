import pytest

from silpose.recording import Header
from silpose.recording import entity_paths as entities
from silpose.recording.layout.views import layout, texts_view
from silpose.recording.stream import recording_stream


@pytest.mark.parametrize(("settings", "visible"), [("seed: 0\n", None), ("", False)])
def test_no_room_is_kept_for_settings_that_there_are_none_of(tmp_path, settings, visible):
    texts = texts_view()
    header = Header("study", "notebook", tmp_path / "run.rrd", "in words", settings)
    with recording_stream(header, layout([texts], [1], 15.0)):
        pass
    views = {view.origin: view.visible for view in texts.contents}
    assert views == {entities.METRICS: None, entities.SETTINGS: visible}

import numpy as np
import pytest
from rerun.chunk import RrdReader

from silpose.recording import entity_paths as entities
from silpose.recording import read_recording, record_study
from silpose.recording.layout import study_layout


def test_errors_of_whatever_is_compared_are_read_back(recordings):
    errors = read_recording(recordings["study"]).errors
    assert {name: values.tolist() for name, values in errors.items()} == {
        name: [0, 1, 2, 3, 4] for name in ("usual", "narrow")
    }


def test_the_figure_is_that_of_the_header(recordings, header, tmp_path, logged):
    png = recordings["study"].with_name("figure.png").read_bytes()
    ((blob,),) = logged(recordings["study"], entities.FIGURE, "EncodedImage:blob", True)
    assert bytes(blob) == png
    record_study(header(tmp_path / "bare.rrd"), {}, "errors", 15.0)
    found = {chunk.entity_path for chunk in RrdReader(tmp_path / "bare.rrd").stream()}
    assert entities.FIGURE not in found


def test_columns_that_are_not_zero_are_counted(recordings, logged):
    left = logged(recordings["bridges"], entities.COLUMNS_LEFT, "Scalars:scalars")
    assert np.ravel(left).tolist() == [3, 2]


def test_each_part_has_the_points_that_it_retains(recordings, sequence, logged):
    for part, count in (("arm", 4), ("leg", 0)):
        entity = f"{entities.RETAINED_POINTS}/{part}"
        points = logged(recordings["features"], entity, "Points2D:positions")
        assert [len(frame) for frame in points] == [count] * len(sequence)


def test_a_plane_of_contexts_has_y_upwards(recordings, logged):
    centres = logged(
        recordings["context_space"], entities.CONTEXT_SPACE_CENTRES, "Points2D:positions", True
    )
    points = logged(
        recordings["context_space"], entities.CONTEXT_SPACE_POINTS, "Points2D:positions"
    )
    assert np.array(centres[0]).shape == (9, 2)
    assert len(points) == 6
    assert np.array(points[0])[:, 1].max() == pytest.approx(0, abs=1e-6)  # shares are positive


def test_the_title_says_which_colour_is_what(header, tmp_path, monkeypatch):
    asked = []

    def layout(title, *arguments):
        asked.append(title)
        return study_layout(title, *arguments)

    monkeypatch.setattr("silpose.recording.study.study_layout", layout)
    series = {"tracker": np.ones(3), "other": np.ones(3)}
    record_study(header(tmp_path / "a.rrd"), series, "errors", 15.0)
    record_study(header(tmp_path / "b.rrd"), series, "errors", 15.0, legend="the darker")
    assert asked == ["errors: tracker (vermilion), other (purple)", "errors: the darker"]

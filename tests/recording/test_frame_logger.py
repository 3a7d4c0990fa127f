import numpy as np
import pytest

from silpose.recording.frame_logger import FrameLogger
from silpose.recording.layout import study_layout
from silpose.recording.stream import recording_stream


@pytest.fixture
def written(header, tmp_path):
    """Write three frames at 2 frames a second with a function of their logger."""

    def write(work):
        path = tmp_path / "run.rrd"
        with recording_stream(header(path), study_layout(None, 2.0)) as recording:
            work(FrameLogger(recording, 3, 2.0))
        return path

    return write


def test_rows_are_at_their_frame_and_second(written, logged):
    path = written(lambda logger: logger.series("/a", np.arange(3.0), "a", (1, 2, 3)))
    assert logged(path, "/a", "frame") == [0, 1, 2]
    seconds = [time.total_seconds() for time in logged(path, "/a", "time")]
    assert seconds == [0, 0.5, 1]


@pytest.mark.parametrize(("largest", "exact"), [(2049.0, False), (1e6 + 1, True)])
def test_bars_are_in_half_precision_if_that_holds_them(written, logged, largest, exact):
    values = np.array([[0, 1], [2, largest], [3, 4]])
    path = written(lambda logger: logger.bars("/a", values, (1, 2, 3)))
    shown = np.array([bar[0]["buffer"] for bar in logged(path, "/a", "BarChart:values")], float)
    assert shown == pytest.approx(values, rel=1e-3)
    assert (shown[1, 1] == largest) == exact


def test_what_is_none_is_not_logged(written, logged):
    states = ["lost", "lost", "tracking"]
    colours = {"lost": (1, 2, 3), "tracking": (4, 5, 6)}
    path = written(lambda logger: logger.states("/a", states, colours))
    assert logged(path, "/a", "frame") == [0, 2]


def test_each_frame_has_as_many_points_as_it_is_given(written, logged):
    points = [np.zeros((n, 2)) for n in (2, 0, 1)]
    colours = np.array([[9, 9, 9], [0, 0, 9]], np.uint8)
    kinds = [np.array(own, int) for own in ([1, 0], [], [1])]
    path = written(lambda logger: logger.points("/a", points, 1.0, kinds=(colours, kinds)))
    drawn = logged(path, "/a", "Points2D:colors")
    assert [len(frame) for frame in drawn] == [2, 0, 1]
    assert drawn[0][0] == drawn[2][0] != drawn[0][1]


def test_a_heading_has_a_gap_where_it_turns_past_180_degrees(written, logged):
    degrees = np.array([170.0, -175.0, -160.0])
    path = written(lambda logger: logger.headings("/a", degrees, "a", (1, 2, 3)))
    assert logged(path, "/a", "frame") == [0, 1, 1, 2]
    assert logged(path, "/a", "Scalars:scalars") == [[170], [], [-175], [-160]]


def test_lines_break_at_a_cut(header, logged, tmp_path):
    path = tmp_path / "run.rrd"
    with recording_stream(header(path), study_layout(None, 2.0)) as recording:
        logger = FrameLogger(recording, 3, 2.0, cuts=[2])
        logger.series("/a", np.array([1.0, 2.0, 3.0]), "a", (1, 2, 3))
        logger.headings("/b", np.array([170.0, -175.0, -160.0]), "b", (1, 2, 3))
    assert logged(path, "/a", "Scalars:scalars") == [[1], [2], [], [3]]
    assert logged(path, "/a", "frame") == [0, 1, 2, 2]
    assert logged(path, "/b", "Scalars:scalars") == [[170], [], [-175], [], [-160]]


def test_joints_have_names_and_connections(written, logged):
    joints, names = np.zeros((3, 2, 3)), ("hip", "left_knee")
    path = written(lambda logger: logger.skeleton("/a", joints, [(0, 1)], names, (90, 90, 90), 0.1))
    assert [len(frame) for frame in logged(path, "/a", "Points3D:positions")] == [2, 2, 2]
    (((described,),),) = logged(path, "/a", "AnnotationContext:context", static=True)
    labels = [point["label"] for point in described["class_description"]["keypoint_annotations"]]
    assert labels == list(names)
    assert len(described["class_description"]["keypoint_connections"]) == 1


def test_bones_of_changing_colours_are_not_covered_by_connections_of_one(written, logged):
    joints, colours = np.zeros((3, 2, 3)), [(9, 0, 0), (0, 9, 0), (0, 9, 0)]
    path = written(lambda logger: logger.skeleton("/a", joints, [(0, 1)], "ab", colours, 0.1))
    (((described,),),) = logged(path, "/a", "AnnotationContext:context", static=True)
    assert not described["class_description"]["keypoint_connections"]
    assert len(described["class_description"]["keypoint_annotations"]) == 2

import numpy as np
from rerun.chunk import RrdReader

from silpose.recording.iteration_logger import IterationLogger
from silpose.recording.layout import study_layout
from silpose.recording.stream import recording_stream


def test_rows_are_at_their_iteration_alone(header, tmp_path):
    path = tmp_path / "run.rrd"
    with recording_stream(header(path), study_layout(None, 2.0)) as recording:
        IterationLogger(recording, 3).series("/cost", np.arange(3.0), "cost", (1, 2, 3))
    (chunk,) = RrdReader(path).stream().filter(content="/cost", is_static=False)
    assert chunk.timeline_names == ["iteration"]
    assert chunk.to_record_batch().column("iteration").to_pylist() == [0, 1, 2]

import numpy as np
import pytest
from rerun.chunk import RrdReader

from silpose.recording import entity_paths as entities
from silpose.recording import read_recording


def test_every_method_has_its_errors(finished):
    recorded = read_recording(finished.recording)
    metric = finished.model.space.metrics[0]
    means = {method: errors.mean() for method, errors in recorded.errors.items()}
    assert means == pytest.approx({m: v[metric] for m, v in finished.metrics.items()}, rel=1e-4)


def test_each_frame_has_its_mask_and_a_histogram_of_all_votes(finished, logged):
    assert len(logged(finished.recording, entities.MASK, "SegmentationImage:buffer")) == 45
    bars = logged(finished.recording, entities.HISTOGRAM, "BarChart:values")
    assert len(bars) == 45
    assert np.sum(bars[7][0]["buffer"]) == pytest.approx(100, abs=0.1)  # percent


def test_examples_weigh_less_from_left_to_right(finished, logged):
    labels = logged(finished.recording, entities.INFLUENTIAL_WEIGHTS, "Points2D:labels")
    assert len(labels) == 45
    for frame in labels:
        weights = [int(label.rstrip("%")) for label in frame]
        assert len(weights) == 5
        assert weights == sorted(weights, reverse=True)
        assert sum(weights) <= 102  # each is rounded


def test_a_catalog_gets_settings_metrics_and_versions(finished):
    groups = {}
    for chunk in RrdReader(finished.recording).stream().filter(content=["/__properties/**"]):
        group = groups.setdefault(chunk.entity_path.removeprefix("/__properties/"), {})
        batch = chunk.to_record_batch()
        values = {name: batch.column(name)[0].as_py() for name in batch.schema.names[1:]}
        group |= {name: value[0] for name, value in values.items()}
    assert groups["settings"]["show"] == "rvm_20"
    assert "recording.root" not in groups["settings"]
    assert groups["metrics"]["rvm_20.mpjpe_mm"] == finished.metrics["rvm_20"]["mpjpe_mm"]
    assert groups["versions"]["rerun"].startswith("0.")

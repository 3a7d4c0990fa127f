from silpose.core.pose_space import SPACES
from silpose.evaluation import HEADLINES, METRICS, headlines


def test_columns_are_what_any_method_has_in_a_fixed_order():
    titles, rows = headlines(
        {
            "knn": {"mpjpe_mm": 35.4, "mean_angular_error_deg": 3.166, "unknown": 1.0},
            "ridge": {"mean_angular_error_deg": 3.12, "kept": 0.184},
        }
    )
    assert titles == ["method", "angles", "joints", "kernels"]
    assert rows == [["knn", "3.17°", "35 mm", ""], ["ridge", "3.12°", "", "18%"]]


def test_the_reported_metric_of_every_space_is_a_headline():
    for space in SPACES.values():
        assert space.metrics[0] in HEADLINES
        assert set(space.metrics) <= set(METRICS)

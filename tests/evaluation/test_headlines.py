from silpose.core.pose_space import SPACES
from silpose.evaluation import HEADLINES, METRICS, best_first, headlines


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


def test_methods_that_are_told_the_truth_come_after_the_best():
    errors = {"oracle": 1.0, "mixture_best4": 1.5, "knn": 3.0, "ridge": 2.0}
    ordered, best = best_first({m: {"mpjpe_mm": e} for m, e in errors.items()} | {"none": {}})
    assert list(ordered) == ["ridge", "knn", "none", "oracle", "mixture_best4"]
    assert best == "ridge"


def test_results_without_a_common_error_keep_their_order():
    results = {"b": {"frames": 0.5}, "a": {"error": 0.1}}
    assert best_first(results) == (results, None)

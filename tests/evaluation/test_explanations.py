from silpose.evaluation import HEADLINES, explanations
from silpose.evaluation.explanations import _COLUMNS


def test_only_what_occurs_is_explained():
    told = explanations({"oracle": {"mpjpe_mm": 3.0}, "ridge": {"heading_over_20deg": 0.1}})
    assert [line.partition(":")[0] for line in told] == ["oracle", "off by 20°"]
    assert explanations({"ridge": {"mpjpe_mm": 3.0}}) == []


def test_only_columns_of_tables_are_explained():
    assert set(_COLUMNS) <= set(HEADLINES)

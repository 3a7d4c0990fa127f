"""scikit-learn's checks of an estimator.

The checks use tables, and masks are no table: a row is drawn as a bar chart, whose shape is the
mask. What the checks show about fitting, cloning, pickling, order and subsets of examples then
holds for the histogram itself.
"""

import numpy as np
import pytest
from sklearn.utils.estimator_checks import parametrize_with_checks
from sklearn.utils.validation import validate_data

from silpose.core.errors import InputError
from silpose.descriptor import ShapeContextHistogram

HEIGHT = 12


class OfBarCharts(ShapeContextHistogram):
    """Describes the rows of a table by the shape of their bar charts."""

    def fit(self, X, y=None):
        return super().fit(self._bar_charts(X, reset=True))

    def transform(self, X):
        if not hasattr(self, "codebook_"):
            return super().transform(X)  # raises NotFittedError
        return super().transform(self._bar_charts(X, reset=False))

    def _bar_charts(self, X, reset):
        table = validate_data(self, X, dtype=float, reset=reset)
        heights = 1 + (HEIGHT - 1) / (1 + np.exp(-table))
        return np.arange(HEIGHT)[::-1, None] < heights[:, None]


@parametrize_with_checks([OfBarCharts(codebook_size=2, edge_points=20, n_jobs=1)])
def test_bar_charts_pass_the_checks(estimator, check):
    check(estimator)


# On the class itself these fail for one reason: the check's data are a table (n, features), and the
# error about it is another one than the check expects.
FEED_TABLES = """
    check_complex_data check_dict_unchanged check_dont_overwrite_parameters check_dtype_object
    check_estimator_sparse_array check_estimator_sparse_matrix check_estimators_dtypes
    check_estimators_empty_data_messages check_estimators_fit_returns_self check_estimators_nan_inf
    check_estimators_overwrite_params check_estimators_pickle check_f_contiguous_array_estimator
    check_fit2d_1feature check_fit2d_1sample check_fit2d_predict1d check_fit_check_is_fitted
    check_fit_idempotent check_fit_score_takes_y check_methods_sample_order_invariance
    check_methods_subset_invariance check_n_features_in check_n_features_in_after_fitting
    check_pipeline_consistency check_positive_only_tag_during_fit check_readonly_memmap_input
    check_transformer_data_not_an_array check_transformer_general check_transformer_preserve_dtypes
""".split()  # noqa: SIM905


@parametrize_with_checks(
    [ShapeContextHistogram(codebook_size=2, edge_points=20, n_jobs=1)],
    expected_failed_checks=lambda _: {name: "feeds tables, not masks" for name in FEED_TABLES},
)
def test_masks_pass_the_checks_that_feed_no_tables(estimator, check):
    check(estimator)


def test_a_table_is_a_clear_error():
    with pytest.raises(InputError, match=r"shape \(30, 3\): expected \(n, height, width\)"):
        ShapeContextHistogram().fit(np.zeros((30, 3)))

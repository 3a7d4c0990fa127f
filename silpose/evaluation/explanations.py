"""What the words in a table of results mean, for those that do not say it themselves."""

from __future__ import annotations

from collections.abc import Mapping

from silpose.evaluation.coverage import LEVEL
from silpose.evaluation.headlines import HEADLINES, Results

_METHODS: Mapping[str, str] = {
    "knn": "five nearest neighbours, weighted",
    "oracle": "the training pose nearest to the true one; copying cannot do better",
    "windowed": "regression on several frames at once",
    "tracker_lag": "the tracker, told a little of what comes next",
}
_COLUMNS: Mapping[str, str] = {
    "varied_scenes_error_deg": "angles, with bodies and cameras that vary more than in training",
    "heading_over_20deg": "frames whose heading is wrong by more than 20°",
    "silhouette_iou": "of the estimated body's silhouette and the mask, 1 if they are equal",
    "coverage_angles": f"true angles within the {LEVEL:.0%} intervals of the estimate",
    "log_likelihood": "of the true pose under the estimate, the higher the better",
    "kept": "training examples that an estimate is made of, of all",
    "extinct": "frames in which no kernel on the pose is active",
    "locked_on": "starts after which nearly all headings are right",
    "gain_lost": "of what is gained over the mean pose",
    "points_share": "of the silhouette's points",
}


def explanations(results: Results) -> list[str]:
    """Explain methods and columns of a table, a line each, where they occur.

    Parameters
    ----------
    results : mapping
        Values by method, then by name.
    """
    present = {name for values in results.values() for name in values}
    lines = {method: words for method, words in _METHODS.items() if method in results}
    lines |= {HEADLINES[name][0]: words for name, words in _COLUMNS.items() if name in present}
    return [f"{name}: {words}" for name, words in lines.items()]

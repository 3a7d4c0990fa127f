"""Headline metrics of a run: their order, titles and formats in a table."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

Results = Mapping[str, Mapping[str, float]]
"""Values by method, then by name."""

HEADLINES: Mapping[str, tuple[str, str]] = {
    "mean_angular_error_deg": ("angles", "{:.2f}°"),
    "varied_scenes_error_deg": ("varied", "{:.2f}°"),
    "mean_joint_distance": ("joints, own units", "{:.2f}"),
    "mpjpe_mm": ("joints", "{:.0f} mm"),
    "heading_median_deg": ("heading", "{:.1f}°"),
    "heading_over_20deg": ("off by 20°", "{:.0%}"),
    "silhouette_iou": ("overlap", "{:.2f}"),
    "overlap": ("overlap", "{:.0%}"),
    "poses_apart_deg": ("poses apart", "{:.1f}°"),
    "coverage_angles": ("covered", "{:.0%}"),
    "log_likelihood": ("log-likelihood", "{:.1f}"),
    "frames": ("frames", "{:.0%}"),
    "frames_by_neighbours": ("by neighbours", "{:.0%}"),
    "frames_by_modes": ("by modes", "{:.0%}"),
    "found_by_modes": ("found", "{:.0%}"),
    "error_of_first": ("error of mode 1", "{:.2f}"),
    "error_of_better": ("of the better", "{:.2f}"),
    "error": ("error", "{:.2f}"),
    "part_error": ("error", "{:.2f}"),
    "mean_pose_error": ("mean pose", "{:.2f}"),
    "functions_kept": ("functions kept", "{:.0f}"),
    "points_share": ("points retained", "{:.0%}"),
    "kept": ("kernels", "{:.0%}"),
    "extinct": ("frames extinct", "{:.0%}"),
    "widest_error": ("worst widths", "{:.2f}"),
    "locked_on": ("starts locked on", "{:.0%}"),
    "within_20deg": ("heading within 20°", "{:.0%}"),
    "back_after_blank": ("back after blank", "{:.0%}"),
    "back_after_cut": ("after cut", "{:.0%}"),
    "whole_error": ("whole masks", "{:.2f}"),
    "gain_lost": ("gain lost", "{:.0%}"),
    "rank_correlation": ("rank correlation", "{:.2f}"),
    "rank_correlation_joints": ("with joints", "{:.2f}"),
    "nearest_pairs": ("nearest pairs", "{:.2f}"),
    "variance_in_plane": ("variance in the plane", "{:.0%}"),
    "centres_voted_for": ("centres voted for", "{:.0f}"),
    "validation_error": ("validation", "{:.2f}"),
    "test_error": ("test", "{:.2f}"),
}

_ERRORS = (
    "mean_angular_error_deg", "mean_joint_distance", "mpjpe_mm", "error", "test_error",
    "whole_error",
)  # fmt: skip
_TOLD_THE_TRUTH = ("oracle", "_best", "given_start")  # in names of methods that know it in part


def best_first(results: Results) -> tuple[dict[str, Mapping[str, float]], str | None]:
    """Put the rows of results in order, that of the least error first.

    Parameters
    ----------
    results : mapping
        Values by method, then by name.

    Returns
    -------
    ordered : dict
        Likewise. Methods that are told some of the truth, such as the oracle, come last.
    best : str or None
        Method of the first row; None if there is no common error, and the order is kept.
    """
    error = next((e for e in _ERRORS if sum(e in own for own in results.values()) > 1), None)
    if error is None:
        return dict(results), None

    def rank(method: str) -> tuple[bool, float]:
        told = any(part in method for part in _TOLD_THE_TRUTH)
        return told, results[method].get(error, float("inf"))

    ordered = {method: results[method] for method in sorted(results, key=rank)}
    best = next(iter(ordered))
    return ordered, None if rank(best)[0] else best


def headlines(results: Results) -> tuple[list[str], list[list[str]]]:
    """Lay results out as a table.

    Parameters
    ----------
    results : mapping
        Values by method, then by name.

    Returns
    -------
    titles : list of str
    rows : list of list of str
        For each method its name and its values.
    """
    present = {name for values in results.values() for name in values}
    shown = {name: column for name, column in HEADLINES.items() if name in present}
    rows = [
        [method, *(f.format(values[n]) if n in values else "" for n, (_, f) in shown.items())]
        for method, values in results.items()
    ]
    return ["method", *(title for title, _ in shown.values())], rows


def in_parts(widths: Sequence[int], room: int) -> list[list[int]]:
    """Divide columns among tables that have room for them.

    Parameters
    ----------
    widths : sequence of int
        Characters of each column, with the gap before it.
    room : int
        Characters of a table, without those of a first column that all tables have.

    Returns
    -------
    parts : list of list of int
        Which columns each table has; at least one.
    """
    parts: list[list[int]] = [[]]
    for k in range(len(widths)):
        wide = sum(widths[j] for j in (*parts[-1], k))
        if parts[-1] and wide > room:
            parts.append([])
        parts[-1].append(k)
    return parts

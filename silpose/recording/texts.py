"""What a recording says in words: the run's settings and its results."""

from __future__ import annotations

from collections.abc import Mapping

from silpose.recording import entities

_COLUMNS = {
    "mean_angular_error_deg": ("angles, °", "{:.2f}"),
    "mean_joint_distance": ("joints", "{:.2f}"),
    "heading_mean_deg": ("heading, °", "{:.1f}"),
    "mpjpe_mm": ("joints, mm", "{:.0f}"),
    "log_likelihood": ("log-likelihood", "{:.1f}"),
    "frames": ("frames", "{:.0%}"),
    "frames_by_neighbours": ("frames, by like silhouettes", "{:.0%}"),
    "frames_by_modes": ("frames, by modes", "{:.0%}"),
    "found_by_modes": ("found", "{:.0%}"),
    "error_of_first": ("error of mode 1", "{:.2f}"),
    "error_of_better": ("of the better", "{:.2f}"),
    "error": ("error", "{:.2f}"),
    "mean_pose_error": ("mean pose", "{:.2f}"),
    "kept": ("kept", "{:.0%}"),
    "functions_kept": ("functions kept", "{:.0f}"),
    "points_share": ("points", "{:.0%}"),
    "extinct": ("frames extinct", "{:.0%}"),
    "widest_error": ("worst widths", "{:.2f}"),
    "locked_on": ("starts that lock on", "{:.0%}"),
    "within_20deg": ("heading within 20°", "{:.0%}"),
}


def texts(
    sequence: str, settings: str, results: Mapping[str, Mapping[str, float]]
) -> dict[str, str]:
    """Write what was seen, settings (YAML) and headline results as markdown, by entity."""
    return {
        entities.SEQUENCE: sequence,
        entities.SETTINGS: f"```yaml\n{settings}```\n",
        entities.METRICS: f"{sequence}\n\n{results_table(results)}" if results else sequence,
    }


def results_table(results: Mapping[str, Mapping[str, float]]) -> str:
    """Write the headlines as a markdown table, a row per method."""
    shown = {n: c for n, c in _COLUMNS.items() if any(n in values for values in results.values())}
    lines = ["| method | " + " | ".join(title for title, _ in shown.values()) + " |"]
    lines.append("|:--|" + "--:|" * len(shown))
    for method, values in results.items():
        cells = [f.format(values[n]) if n in values else "" for n, (_, f) in shown.items()]
        lines.append(f"| {method} | " + " | ".join(cells) + " |")
    return "\n".join(lines)

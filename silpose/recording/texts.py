"""What a recording says in words: the run's settings and its results."""

from __future__ import annotations

from silpose.headlines import Results, headlines
from silpose.recording import entities


def texts(sequence: str, settings: str, results: Results) -> dict[str, str]:
    """Write what was seen, settings (YAML) and headline results as markdown, by entity."""
    return {
        entities.SEQUENCE: sequence,
        entities.SETTINGS: f"```yaml\n{settings}```\n",
        entities.METRICS: f"{sequence}\n\n{results_table(results)}" if results else sequence,
    }


def results_table(results: Results) -> str:
    """Write the headlines as a markdown table, a row per method."""
    titles, rows = headlines(results)
    ruler = ":--|" + "--:|" * (len(titles) - 1)
    table = [" | ".join(titles), ruler.strip("|"), *(" | ".join(row) for row in rows)]
    return "\n".join(f"| {line} |" for line in table)

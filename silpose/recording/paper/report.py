"""The report of the whole paper: one page that needs nothing else, and the same as text."""

from __future__ import annotations

import base64
import re
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup, escape

from silpose.core.atomic_files import writing
from silpose.evaluation import BASELINES
from silpose.recording.page_style import PAGE_HEAD, PAGE_STYLE
from silpose.recording.paper.claims import CLAIMS, Claim
from silpose.recording.paper.found import Found

_SECTIONS = {
    "Abstract, I": "Introduction", "II-A": "Silhouettes and shape contexts",
    "II-B": "Poses and data", "III-A": "Ridge regression",
    "III-B": "Relevance vector regression", "III-C": "Kernels",
    "IV-A": "Which silhouette points matter", "IV-B": "Pose from one silhouette",
    "V, note 4": "Several silhouettes", "V-A": "Dynamics in the regressor", "V-B": "Tracking",
    "VI": "Several poses", "beyond": "Beyond the paper",
}  # fmt: skip


@dataclass(frozen=True)
class PaperReport:
    """What the report says.

    Attributes
    ----------
    found : mapping of str to mapping of str to Found
        By protocol (``walkers``, ``authors``), then by experiment.
    seconds : mapping of str to float
        By part (``walkers/tracking``).
    failed : mapping of str to str
        Reason by part of what did not end well.
    folder : Path
        Folder of the runs, where the report is written.
    note : str, default=""
        What a reader must know before anything else.
    """

    found: Mapping[str, Mapping[str, Found]]
    seconds: Mapping[str, float]
    failed: Mapping[str, str]
    folder: Path
    note: str = ""

    def sections(self) -> list[tuple[str, list[dict[str, object]]]]:
        """Titles, each with its claims in words."""
        return [
            (f"{section}: {_SECTIONS[section]}", _told_once([self._words(c) for c in claims]))
            for section, claims in groupby(CLAIMS, key=lambda claim: claim.section)
        ]

    def counts(self) -> dict[str, int]:
        """Count the claims by verdict."""
        words = [claim["word"] for _, claims in self.sections() for claim in claims]
        return {str(word): words.count(word) for word in dict.fromkeys(words)}

    def _words(self, claim: Claim) -> dict[str, object]:
        own = {
            protocol: found
            for protocol, by_name in self.found.items()
            if (found := by_name.get(claim.experiment or "")) is not None
        }
        ours = {protocol: words for protocol, f in own.items() if (words := _ours(claim, f))}
        first = next((own[protocol] for protocol in ours), None if claim.ours else _any(own))
        word, sentence = claim.verdict(first)
        figure = first.run.folder / f"{claim.experiment}.png" if first and _draws(claim) else None
        reason = next(
            (why for part, why in self.failed.items() if part.endswith(f"/{claim.experiment}")), ""
        )
        if word == "not run" and reason:
            sentence = f"It failed: {reason}"
        return {
            "item": claim.item,
            "says": claim.says,
            "number": claim.number,
            "experiment": claim.experiment or "",
            "ours": ours,
            "baselines": _baselines(first) if ours and first else "",
            "word": word,
            "sentence": sentence,
            "figure": figure if figure and figure.is_file() else None,
            "recording": first.run.recording if first and first.run.recording.is_file() else None,
        }


def write_paper(report: PaperReport) -> tuple[Path, Path]:
    """Write ``report.html``, one file without network, and ``report.md``, into the runs' folder.

    Parameters
    ----------
    report : PaperReport

    Returns
    -------
    page, text : Path
    """
    templates = Environment(
        loader=PackageLoader("silpose.recording.paper", "templates"),
        autoescape=lambda name: name is not None and name.startswith("report.html"),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    templates.globals["page_head"] = Markup(PAGE_HEAD)
    templates.globals["page_style"] = Markup(PAGE_STYLE)
    templates.filters["with_code"] = _with_code
    templates.filters["embedded"] = _embedded
    templates.filters["below"] = lambda path: path.relative_to(report.folder).as_posix()
    written = []
    for name in ("report.html", "report.md"):
        text = templates.get_template(f"{name}.j2").render(report=report)
        with writing(report.folder / name) as file:
            file.write_text(text, encoding="utf-8")
        written.append(report.folder / name)
    return written[0], written[1]


def _draws(claim: Claim) -> bool:
    """Whether a claim shows its experiment's figure: the first about one, else the first."""
    same = [each for each in CLAIMS if each.experiment == claim.experiment]
    return claim is next((each for each in same if each.item.startswith("Fig")), same[0])


def _told_once(claims: list[dict[str, object]]) -> list[dict[str, object]]:
    """Keep the baselines of an experiment at the first of a section's claims that has them."""
    told = set()
    for words in claims:
        if words["baselines"] and words["experiment"] in told:
            words["baselines"] = ""
        elif words["baselines"]:
            told.add(words["experiment"])
    return claims


def _with_code(text: str) -> Markup:
    """Escape a sentence for HTML, and set what stands between backticks as code."""
    return Markup(re.sub(r"`([^`]+)`", r"<code>\1</code>", str(escape(text))))


def _any(own: Mapping[str, Found]) -> Found | None:
    return next(iter(own.values()), None)


def _ours(claim: Claim, found: Found) -> str:
    """Our number in words; empty where the data or the settings gave no such value."""
    try:
        return claim.ours(found) if claim.ours else ""
    except LookupError:
        return ""


def _embedded(figure: Path) -> str:
    return "data:image/png;base64," + base64.b64encode(figure.read_bytes()).decode()


def _baselines(found: Found) -> str:
    """Errors of the baselines, where the experiment has them."""
    if not {*BASELINES} <= {*found.methods}:
        return ""
    return ", ".join(f"{name.replace('_', ' ')} {found.words(name)}" for name in BASELINES)

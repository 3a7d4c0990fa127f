"""Claims of section VI, mixtures of regressors, and what goes beyond the paper."""

from __future__ import annotations

from silpose.recording.paper.claims.claim import Claim
from silpose.recording.paper.found import Found


def _back(found: Found, method: str) -> str:
    return found.words(method, "back_after_blank", percent=True)


MIXTURES = (
    Claim(
        "VI", "Eq. 11", "A mixture of regressors returns several poses, each with its probability.",
        experiment="mixture",
        ours=lambda f: f"most probable {f.words('mixture_top1')}, best of four "
        f"{f.words('mixture_best4')}; best of four neighbours {f.words('neighbours_best4')}",
        holds=lambda f: f.value("mixture_best4") < f.value("neighbours_best4"),
        agrees="One of few poses is right more often than one of as many neighbours.",
        differs="As many neighbours hold a pose as good.",
    ),
    Claim(
        "VI", "text", "Some silhouettes have several explanations.", experiment="ambiguity",
        agrees="The figure shows which, and how their poses differ.",
    ),
    Claim(
        "VI", "text", "Tracking several hypotheses needs no pose to start from, and recovers.",
        experiment="hypotheses",
        ours=lambda f: f"{f.words('hypotheses')} without a start; right again after blank masks in "
        f"{_back(f, 'hypotheses')} of the trials",
        holds=lambda f: f.value("hypotheses") <= 1.02 * f.value("tracker_given_start"),
        agrees="It is as good without a pose to start from as a tracker that is given one.",
        differs="A tracker that is given its start is better.",
    ),
    Claim(
        "beyond", "", "A body fitted to the mask's contour, started from these estimates.",
        experiment="fitting",
        ours=lambda f: f"{f.words('fitted_take')}, {f.value('fitted_take', 'mpjpe_mm'):.0f} mm; "
        f"tracker with a lag {f.words('tracker_lag')}, "
        f"{f.value('tracker_lag', 'mpjpe_mm'):.0f} mm",
        holds=lambda f: f.value("fitted_take") < f.value("tracker_lag"),
        agrees="Fitting repairs what regression cannot know.",
        differs="Fitting does not help here.",
    ),
)  # fmt: skip

"""All experiments: the question of each, and what its table of results shows."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class Entry:
    """An experiment in the catalogue.

    Attributes
    ----------
    question : str
        What it answers, in one sentence or two.
    table : str, default="errors on unseen takes"
        What the table of its results shows.
    rows : str, default="method"
        What each row of that table is.
    """

    question: str
    table: str = "errors on unseen takes"
    rows: str = "method"


CATALOGUE: Mapping[str, Entry] = {
    "single_image": Entry(
        "How well can pose be estimated from one silhouette? Which training examples weigh most "
        "in an estimate?"
    ),
    "predict": Entry("What poses are behind my own masks?"),
    "video": Entry("What are the poses and the gait of a person in my film?"),
    "masks": Entry("How are my own masks read, and what is in them?"),
    "motion_report": Entry("What is understood of my own motion capture?"),
    "contact_sheet": Entry("What do the silhouettes look like that are trained on?"),
    "lookalikes": Entry(
        "Which different poses have nearly the same silhouette?",
        "how much two silhouettes overlap, and how far apart their poses are",
        "two frames",
    ),
    "training_data": Entry(
        "How much do more frames, bodies and cameras help on unseen performers?",
        "errors on unseen performers",
        "method, training data, frames",
    ),
    "descriptor_space": Entry(
        "What do shape contexts and their codebook look like?",
        "what the plane of two principal components holds",
        "of",
    ),
    "similarity": Entry(
        "Are silhouettes alike where poses are?",
        "how well distances of silhouettes agree with distances of poses",
        "distance",
    ),
    "descriptor_robustness": Entry(
        "What do holes, occluders, shadows cost, beside Hu moments and aligned masks?",
        "errors on whole silhouettes, and what is lost when a part of the contour is damaged",
        "descriptor",
    ),
    "descriptor_choices": Entry(
        "Which choices of the descriptor matter?",
        "errors of kernel ridge regression, one setting changed at a time",
        "setting",
    ),
    "bridges": Entry(
        "How does the relevance vector machine become sparse?",
        "basis functions that are left at the end",
        "regressor",
    ),
    "parts": Entry(
        "How sparse may each body part's regressor be?",
        "errors of the parts on unseen takes, and basis functions kept",
        "body part",
    ),
    "feature_selection": Entry(
        "Which silhouette points determine a body part's pose?",
        "what each part's regressor keeps",
        "body part",
    ),
    "regressors": Entry("Does the kind of regressor, of basis, of kernel matter?"),
    "tracking": Entry("What do dynamics add to what is seen?"),
    "extinction": Entry(
        "What happens when the pose kernel is too narrow?",
        "errors of the tracker on an unseen take",
        "pose kernel",
    ),
    "damping": Entry(
        "How far should the tracker follow its dynamics?",
        "errors of the tracker on unseen takes, by the linear term s",
        "linear term",
    ),
    "kernel_widths": Entry(
        "How exactly must the tracker's kernels be tuned?",
        "errors on unseen takes, at the best and the worst kernel widths",
        "tracker",
    ),
    "initialisation": Entry(
        "From which frames does a tracker lock on by itself?",
        "frames to start from, of an unseen take",
        "tracker",
    ),
    "mixture": Entry(
        "How good is the best of several poses, and how well do their probabilities tell which "
        "it is?"
    ),
    "ambiguity": Entry(
        "Which silhouettes have several explanations?",
        "unseen frames whose silhouette has two explanations",
        "they differ in",
    ),
    "hypotheses": Entry(
        "Which of several poses is right, when no pose is given, masks are blank, the video is cut?"
    ),
    "fitting": Entry(
        "How much does the mask's contour add to regression and tracking, with camera and body "
        "shape known, estimated, and without regression?"
    ),
    "fitting_robustness": Entry(
        "What do holes, occluders, shadows cost a fitted body, beside regression and tracking?",
        "errors on whole silhouettes, and what is lost when they are degraded",
    ),
}
"""By name, which is that of a module of this package and of its function."""

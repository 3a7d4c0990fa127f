"""What validation chooses the settings of trackers and of their baselines from."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, fields

from silpose.core.errors import InputError
from silpose.core.parameters import (
    NOT_NEGATIVE,
    POSITIVE,
    POSITIVE_INTEGER,
    Constraint,
    check_values,
)
from silpose.core.types import Settings
from silpose.regression import Candidates
from silpose.tracking.belief_tracker import BeliefTracker
from silpose.tracking.dynamics import SecondOrderDynamics
from silpose.tracking.multiple_hypothesis_tracker import MultipleHypothesisTracker
from silpose.tracking.single_pose_tracker import SinglePoseTracker
from silpose.tracking.state_sensitive import StateSensitiveRegressor


@dataclass(frozen=True)
class SmoothingBaselines:
    """Values to choose from for what else makes single-image estimates smooth.

    Attributes
    ----------
    smoothing : sequence of int, default=(5, 9, 13, 17, 21)
        Lengths of the Savitzky-Golay filter, frames.
    window : sequence of int, default=(3, 5, 9, 17)
        Numbers of frames whose descriptors are regressed on together.
    neighbours : sequence of int, default=(20, 50)
        Numbers of training examples that may explain a frame.
    viterbi_weight : sequence of float, default=(1, 3, 10, 30)
        Weights of the squared change of pose along a path of training examples.
    fusion : sequence of float, default=(0.2, 0.4, 0.6, 0.8)
        Weights of dynamics when they are blended with single-image estimates.
    """

    smoothing: Sequence[int] = (5, 9, 13, 17, 21)
    window: Sequence[int] = (3, 5, 9, 17)
    neighbours: Sequence[int] = (20, 50)
    viterbi_weight: Sequence[float] = (1, 3, 10, 30)
    fusion: Sequence[float] = (0.2, 0.4, 0.6, 0.8)

    def __post_init__(self) -> None:
        constraints: dict[str, Constraint] = {
            "smoothing": POSITIVE_INTEGER,
            "window": POSITIVE_INTEGER,
            "neighbours": POSITIVE_INTEGER,
            "viterbi_weight": POSITIVE,
            "fusion": POSITIVE,
        }
        for own in fields(self):
            check_values(own.name, constraints[own.name], *getattr(self, own.name))


@dataclass(frozen=True)
class TrackingCandidates:
    """Trackers and baselines, and the values that their settings are chosen from.

    Attributes
    ----------
    tracker : Candidates of BeliefTracker
    dynamics : Candidates of SecondOrderDynamics
    state_sensitive : Candidates of StateSensitiveRegressor
        Of the paper's tracker.
    single_pose : Candidates of SinglePoseTracker
        The paper's tracker, whose dynamics and regressor are the two above.
    hypotheses : Candidates of MultipleHypothesisTracker
    baselines : SmoothingBaselines
    lag : float, default=0.5
        Seconds that estimates wait for, where they may wait.
    """

    tracker: Candidates[BeliefTracker] = field(default_factory=lambda: Candidates(BeliefTracker()))
    dynamics: Candidates[SecondOrderDynamics] = field(
        default_factory=lambda: Candidates(SecondOrderDynamics())
    )
    state_sensitive: Candidates[StateSensitiveRegressor] = field(
        default_factory=lambda: Candidates(StateSensitiveRegressor())
    )
    single_pose: Candidates[SinglePoseTracker] = field(
        default_factory=lambda: Candidates(SinglePoseTracker())
    )
    hypotheses: Candidates[MultipleHypothesisTracker] = field(
        default_factory=lambda: Candidates(MultipleHypothesisTracker())
    )
    baselines: SmoothingBaselines = field(default_factory=SmoothingBaselines)
    lag: float = 0.5

    def __post_init__(self) -> None:
        check_values("lag", NOT_NEGATIVE, self.lag)


def settings_to_choose(
    group: str, candidates: Candidates, *always: str, also: Sequence[str] = ()
) -> list[Settings]:
    """List the settings that a search is to score.

    Parameters
    ----------
    group : str
        Config group of the candidates below ``tracking``.
    candidates : Candidates
    *always : str
        Parameters that every setting has.
    also : sequence of str, default=()
        Further parameters that may be in the grid.

    Raises
    ------
    InputError
        If another parameter is in the grid.
    """
    names = candidates.names(*always)
    for name in names:
        if name not in (*always, *also):
            raise InputError(
                f"tracking.{group}.{name} is not chosen by validation: give one value instead of "
                f"{list(candidates.grid[name])}"
            )
    return candidates.settings(*names) if names else [{}]

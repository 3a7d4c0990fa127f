"""Settings of tracking: one value, or a list for validation to choose from."""

from __future__ import annotations

from dataclasses import dataclass, field

from silpose.core.errors import InputError

Values = float | list[float]


def _check(settings: object, group: str, *names: str) -> None:
    for name in names:
        value = getattr(settings, name)
        values = [value] if isinstance(value, int | float) else list(value)
        if not values or not all(isinstance(v, int | float) and v > 0 for v in values):
            raise InputError(f"tracking.{group}.{name} is to be positive numbers, not {value!r}")


def _check_shares(settings: TrackerSettings | HypothesesSettings, group: str) -> None:
    for name in ("heading_alone", "body_alone"):
        share = getattr(settings, name)
        if share is not None and not 0 <= share <= 1:
            raise InputError(f"tracking.{group}.{name} is a share from 0 to 1, not {share}")


@dataclass(frozen=True)
class TrackerSettings:
    """Of `BeliefTracker`, and the seconds that it may wait where it may wait.

    Shares regressed on the silhouette alone are stacked on validation sequences unless given.
    """

    keep: float = 0.18
    pose_width: Values = field(default_factory=lambda: [0.2, 0.3, 0.45, 0.7, 1.0])
    descriptor_width: Values = field(default_factory=lambda: [0.6, 0.8, 1.0, 1.3, 1.6, 2.0])
    damping: Values = field(default_factory=lambda: [1.0, 4.0])
    heading_alone: float | None = None
    body_alone: float | None = None
    restart: float = 1e-6
    lag: float = 0.5
    random_state: int | None = 0

    def __post_init__(self) -> None:
        _check(self, "tracker", "keep", "pose_width", "descriptor_width", "damping")
        _check_shares(self, "tracker")
        if not self.lag >= 0:
            raise InputError(f"tracking.tracker.lag is 0 or more seconds, not {self.lag}")


@dataclass(frozen=True)
class DynamicsSettings:
    """Of `SecondOrderDynamics`."""

    damping: Values = field(default_factory=lambda: [1.0, 10.0, 100.0, 1000.0])

    def __post_init__(self) -> None:
        _check(self, "dynamics", "damping")


@dataclass(frozen=True)
class JointSettings:
    """Of the paper's tracker: `SinglePoseTracker` and `StateSensitiveRegressor`."""

    pose_width: Values = field(default_factory=lambda: [0.5, 1.0, 2.0])
    descriptor_width: Values = field(default_factory=lambda: [1.0, 2.0, 4.0])
    linear: float | None = None
    damping: float = 0.1
    keep_at_most: float = 0.18
    samples: int = 3
    centres: int = 2000
    random_state: int | None = 0

    def __post_init__(self) -> None:
        _check(
            self, "joint", "pose_width", "descriptor_width", "damping", "keep_at_most", "centres"
        )


@dataclass(frozen=True)
class HypothesesSettings:
    """Of `MultipleHypothesisTracker`; shares as those of `TrackerSettings`."""

    count: int = 200
    drift: Values = 0.3
    trust: Values = field(default_factory=lambda: [0.03, 0.05, 0.1])
    past: Values = field(default_factory=lambda: [0.5, 0.7, 0.85])
    fresh: float = 0.001
    keep: float = 0.18
    pose_width: float = 0.5
    descriptor_width: float = 1.0
    damping: float = 4.0
    heading_alone: float | None = None
    body_alone: float | None = None
    random_state: int | None = 0

    def __post_init__(self) -> None:
        _check(self, "hypotheses", "count", "drift", "trust", "past", "fresh")
        _check(self, "hypotheses", "keep", "pose_width", "descriptor_width", "damping")
        _check_shares(self, "hypotheses")


@dataclass(frozen=True)
class RivalSettings:
    """Of what else makes estimates smooth; windows in frames."""

    smoothing: list[int] = field(default_factory=lambda: [5, 9, 13, 17, 21])
    window: list[int] = field(default_factory=lambda: [3, 5, 9, 17])
    neighbours: list[int] = field(default_factory=lambda: [20, 50])
    viterbi_weight: Values = field(default_factory=lambda: [1.0, 3.0, 10.0, 30.0])
    fusion: Values = field(default_factory=lambda: [0.2, 0.4, 0.6, 0.8])

    def __post_init__(self) -> None:
        _check(self, "rivals", "smoothing", "window", "neighbours", "viterbi_weight", "fusion")


@dataclass(frozen=True)
class TrackingSettings:
    """All of them."""

    tracker: TrackerSettings = field(default_factory=TrackerSettings)
    dynamics: DynamicsSettings = field(default_factory=DynamicsSettings)
    joint: JointSettings = field(default_factory=JointSettings)
    hypotheses: HypothesesSettings = field(default_factory=HypothesesSettings)
    rivals: RivalSettings = field(default_factory=RivalSettings)

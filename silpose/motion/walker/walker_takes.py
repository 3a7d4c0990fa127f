"""The default source of motion: takes of statistical walkers, which need no data."""

from __future__ import annotations

import numpy as np

from silpose.core.errors import InputError
from silpose.motion.motion import Motion
from silpose.motion.motion_source import MotionSource
from silpose.motion.walker.paths import Circle, Path, Spiral
from silpose.motion.walker.walker import Walker
from silpose.motion.walker.walker_model import WalkerModel

# Kind, whether it turns left, share of the training turns, first heading. Spirals and circles make
# whole turns and arcs, which are nearly straight walks, one half of a circle each, so that all
# headings are about equally frequent.
_TRAINING = (
    ("spiral", True, 1.0, 0.0),
    ("spiral", False, 1.0, 90.0),
    ("circle", True, 1.0, 45.0),
    ("circle", False, 1.0, 225.0),
    ("arc", True, 0.25, 0.0),
    ("spiral", True, 1.0, 180.0),
    ("spiral", False, 1.0, 270.0),
    ("arc", False, 0.25, 0.0),
)


class WalkerTakes(MotionSource):
    """Ten takes of statistical walkers: eight of training, one of validation and one of test.

    Each is of another walker. In training, walkers go along decreasing spirals, circles and wide
    arcs in both directions; in validation and test along decreasing spirals, as in the paper
    (test: 418 frames, 1038 degrees).

    Parameters
    ----------
    seed : int, default=0
        Draws the walkers, their strides and the first headings.
    seconds : float, default=17.0
        Duration of each training take.
    test_seconds : float, default=28.0
        Duration of the validation and of the test take.
    frames_per_second : float, default=15.0
        Frames per second of all takes.
    turns : float, default=2.0
        Full turns of each training spiral and circle; arcs make a quarter of them.
    test_turns : float, default=2.9
        Full turns of the validation and of the test spiral.
    radius_ratio : float, default=2.0
        First radius of a spiral over its last.
    spread : float, default=0.5
        Variation between walkers, as a share of the variation between people; at 0 all are the
        mean walker, whose strides still vary.

    Raises
    ------
    InputError
        If a parameter is not positive, or takes would have fewer than two frames.
    """

    name = "walker"

    def __init__(
        self,
        *,
        seed: int = 0,
        seconds: float = 17.0,
        test_seconds: float = 28.0,
        frames_per_second: float = 15.0,
        turns: float = 2.0,
        test_turns: float = 2.9,
        radius_ratio: float = 2.0,
        spread: float = 0.5,
    ) -> None:
        for name, value in (
            ("seconds", seconds), ("test_seconds", test_seconds),
            ("frames_per_second", frames_per_second), ("turns", turns),
            ("test_turns", test_turns), ("radius_ratio", radius_ratio),
        ):  # fmt: skip
            if not 0 < value < np.inf:
                raise InputError(f"motion.{name} must be a positive number, not {value}")
        if not 0 <= spread < np.inf:
            raise InputError(f"motion.spread must be zero or positive, not {spread}")
        if min(seconds, test_seconds) * frames_per_second < 2:
            raise InputError(
                "motion.seconds times motion.frames_per_second makes fewer than 2 frames a take; "
                "raise one of them"
            )
        self.seed = seed
        self.seconds = seconds
        self.test_seconds = test_seconds
        self.frames_per_second = frames_per_second
        self.turns = turns
        self.test_turns = test_turns
        self.radius_ratio = radius_ratio
        self.spread = spread

    def read(self) -> list[Motion]:
        """Synthesise the takes.

        Returns
        -------
        takes : list of Motion
            ``train_1_spiral`` to ``train_8_arc``, ``validation`` and ``test``, by
            performers ``walker_1`` to ``walker_10``.
        """
        model = WalkerModel.load()
        # Each take has its own random numbers, so that its length does not change the others.
        streams = [np.random.default_rng([self.seed, k]) for k in range(len(_TRAINING) + 3)]
        first_heading = streams.pop().uniform(0.0, 360.0)
        plans = [
            (f"train_{k}_{kind}", kind, left, self.seconds, share * self.turns, heading)
            for k, (kind, left, share, heading) in enumerate(_TRAINING, start=1)
        ]
        plans += [
            ("validation", "spiral", False, self.test_seconds, self.test_turns, 135.0),
            ("test", "spiral", True, self.test_seconds, self.test_turns, 315.0),
        ]
        takes = []
        for k, (plan, rng) in enumerate(zip(plans, streams, strict=True)):
            name, kind, left, seconds, turns, heading = plan
            walker = model.sample(rng, self.spread)
            path = self._path(kind, left, first_heading + heading, turns, seconds, walker)
            takes.append(
                walker.walk(
                    path, seconds, self.frames_per_second, rng, name, performer=f"walker_{k + 1}"
                )
            )
        return takes

    def _path(
        self, kind: str, left: bool, heading: float, turns: float, seconds: float, walker: Walker
    ) -> Path:
        """Choose the radius by the walker's speed, so that all turns are made in time."""
        radius = walker.speed * seconds / (2 * np.pi * turns)
        if kind != "spiral":
            return Circle(radius, heading, left)
        last = 2 * radius / (1 + self.radius_ratio)
        return Spiral(self.radius_ratio * last, last, turns, heading, left)

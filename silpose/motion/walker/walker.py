"""A walker: one person's gait as a mean posture and two harmonics of the stride.

References
----------
N. F. Troje, "Decomposing biological motion", Journal of Vision 2002.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from scipy.interpolate import CubicSpline, PchipInterpolator
from scipy.ndimage import gaussian_filter1d
from scipy.special import expit

from silpose.core import skeleton
from silpose.core.types import Array
from silpose.motion.motion import Motion
from silpose.motion.walker.gait import harmonics_basis
from silpose.motion.walker.paths import Path

_FINE = 4  # substeps per frame, so that the feet's motion integrates accurately
_CONTACT = 0.01  # metres by which heel or ball must be lower to bear the foot's weight alone


@dataclass(frozen=True)
class Variation:
    """Variation between the strides of one walk; if all is zero, they are alike.

    Attributes
    ----------
    stride_time : float, default=0.0
        Standard deviation of a stride's duration, as a share of it.
    amplitude : float, default=0.0
        Standard deviation of the harmonics' amplitude from stride to stride, as a share of it.
    posture : ndarray, shape (54,)
        Standard deviation of the slow drift of each angle, degrees, by default zero.
    """

    stride_time: float = 0.0
    amplitude: float = 0.0
    posture: Array = field(default_factory=lambda: np.zeros(len(skeleton.ANGLES)))


@dataclass(frozen=True)
class Walker:
    """One person's gait.

    Attributes
    ----------
    mean : ndarray, shape (54,)
        Mean posture, degrees, in the order of `silpose.core.skeleton.ANGLES`; 0 for the heading.
    harmonics : ndarray, shape (2, 2, 54)
        Degrees; the axes are harmonic, cosine and sine, angle. At phase 0 the left ankle passes
        the right one on its way forward. The heading oscillates about the direction of travel.
    cadence : float
        Strides per second; a stride is two steps.
    variation : Variation
    """

    mean: Array
    harmonics: Array
    cadence: float
    variation: Variation = field(default_factory=Variation)

    def angles(self, phase: Array, amplitude: float | Array = 1.0) -> Array:
        """Angles of the gait without variation, the heading relative to the travel.

        Parameters
        ----------
        phase : ndarray, shape (F,)
            Radians.
        amplitude : float or ndarray, shape (F,), default=1.0
            Factor of the harmonics.

        Returns
        -------
        angles : ndarray, shape (F, 54)
            Degrees.
        """
        waves = np.einsum("fhc,hca->fa", harmonics_basis(phase), self.harmonics)
        return self.mean + np.reshape(amplitude, (-1, 1)) * waves

    @property
    def stride_length(self) -> float:
        """Metres that the root advances in a stride if the feet on the ground do not slip."""
        phase = np.linspace(0.0, 2 * np.pi, 201)
        return float(_advance(skeleton.rotations_from_angles(self.angles(phase)))[-1, 1])

    @property
    def speed(self) -> float:
        """Metres per second."""
        return self.stride_length * self.cadence

    def walk(
        self,
        path: Path,
        seconds: float,
        frames_per_second: float,
        rng: np.random.Generator,
        name: str = "walk",
        performer: str = "walker",
    ) -> Motion:
        """Synthesise a walk along a path, with strides that vary.

        Parameters
        ----------
        path : Path
        seconds : float
        frames_per_second : float
        rng : numpy.random.Generator
            Draws the first phase and the variation between strides.
        name : str, default="walk"
            Name of the motion.
        performer : str, default="walker"
            Performer of the motion.

        Returns
        -------
        motion : Motion
            The lowest point of the soles is on the ground in every frame, and the root moves
            along the path so that the feet on the ground do not slip.
        """
        frames = round(seconds * frames_per_second)
        time = np.arange((frames - 1) * _FINE + 1) / (_FINE * frames_per_second)
        strides = self._strides(time, rng)
        varied = self.variation
        amplitude = 1.0 + varied.amplitude * _smooth_noise(strides, 1, 1.0, rng)
        drift = varied.posture * _smooth_noise(strides, len(skeleton.ANGLES), 2.0, rng)
        angles = self.angles(2 * np.pi * strides, amplitude) + drift

        rotations = skeleton.rotations_from_angles(angles)
        sway, distance = _advance(rotations).T
        distance = np.maximum.accumulate(distance)
        # A walker whose legs differ would slowly leave the path: only its sway is kept.
        stride_frames = _FINE * frames_per_second / self.cadence
        sway = sway - gaussian_filter1d(sway, stride_frames / 2, mode="nearest")
        direction = path.direction(distance)
        position = path.position(distance)
        azimuth = np.deg2rad(direction)
        position[:, 0] += sway * np.cos(azimuth)
        position[:, 2] -= sway * np.sin(azimuth)
        position[:, 1] = skeleton.standing_height(rotations)
        angles[:, 0] = (angles[:, 0] + direction + 180.0) % 360.0 - 180.0
        return Motion(
            name,
            performer,
            float(frames_per_second),
            angles[::_FINE],
            position[::_FINE],
            synthetic=True,
        )

    def _strides(self, time: Array, rng: np.random.Generator) -> Array:
        """Draw the number of strides walked at each time, shape (F,), with uneven durations."""
        count = int(np.ceil(time[-1] * self.cadence * 1.3)) + 3
        noise = np.clip(rng.standard_normal(count), -2, 2)
        durations = (1.0 + self.variation.stride_time * noise) / self.cadence
        starts = np.concatenate([[0.0], np.cumsum(durations)])
        first = rng.uniform(0.0, 1.0) / self.cadence
        return PchipInterpolator(starts, np.arange(count + 1))(time + first)


def _smooth_noise(strides: Array, columns: int, every: float, rng: np.random.Generator) -> Array:
    """Smooth noise of unit variance, shape (F, columns), with a new value every so many strides."""
    knots = np.arange(np.ceil(strides[-1] / every) + 2) * every
    values = np.clip(rng.standard_normal((len(knots), columns)), -2, 2)
    return CubicSpline(knots, values)(strides)


def _advance(rotations: Array) -> Array:
    """Path of the root, to the left and forward, if the foot that bears the weight does not slip.

    Each foot is at its heel or ball, whichever is lower. The foot that moves backward under the
    body bears the weight, as a swinging foot may graze the ground.

    Parameters
    ----------
    rotations : ndarray, shape (F, 18, 3, 3)
        Rotation of each joint relative to its parent, in a walk that faces +Z.

    Returns
    -------
    path : ndarray, shape (F, 2)
        Metres from the first frame.
    """
    positions, orientations = skeleton.forward_kinematics(rotations)
    feet = []
    for ankle, sole in skeleton.SOLES.items():
        j = skeleton.JOINTS.index(ankle)
        points = positions[:, j, None] + np.einsum("fij,sj->fsi", orientations[:, j], sole)
        lower = expit((points[:, 0, 1] - points[:, 1, 1]) / _CONTACT)  # 1: the ball
        lower = (lower[1:] + lower[:-1])[:, None] / 2
        heel, ball = np.diff(points[..., [0, 2]], axis=0).transpose(1, 0, 2)
        feet.append((1 - lower) * heel + lower * ball)
    left, right = feet
    # Relative to the feet's typical difference, so that the frame rate does not matter.
    typical = np.abs(left[:, 1] - right[:, 1]).mean() + 1e-12
    on_right = expit(5 * (left[:, 1] - right[:, 1]) / typical)[:, None]
    steps = -(1 - on_right) * left - on_right * right
    return np.concatenate([np.zeros((1, 2)), np.cumsum(steps, axis=0)])

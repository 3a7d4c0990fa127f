"""Takes from motion: poses are rendered in front of cameras."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from silpose.core.pose_space import ANGLES
from silpose.core.progress import bar
from silpose.dataset.lazy_masks import LazyMasks
from silpose.dataset.scenes import Scene, SceneSampler
from silpose.dataset.take import Take
from silpose.motion import Motion, MotionSource
from silpose.silhouette import Body, Camera, Degradation, Degrader

HELD = 2**28
"""Memory limit for training masks, bytes; beyond it they are rendered whenever asked for."""


def render_take(
    motion: Motion,
    body: Body,
    camera: Camera,
    *,
    name: str | None = None,
    degrade: Degrader | None = None,
    now: bool = True,
    held: bool = True,
    advance: Callable[[int], None] = lambda frames: None,
) -> Take:
    """Pose the body through a motion and render its masks.

    Parameters
    ----------
    motion : Motion
    body : Body
    camera : Camera
    name : str, optional
        Name of the take, by default the motion's.
    degrade : callable, optional
        From a mask and its frame to the degraded mask.
    now : bool, default=True
        Whether masks are rendered now, rather than when they are asked for.
    held : bool, default=True
        Whether they then stay in memory, which all that are rendered now do.
    advance : callable, optional
        Called with 1 after every rendered mask.

    Returns
    -------
    take : Take
        The headings of its poses are relative to the camera.

    Raises
    ------
    InputError
        If the person is out of the camera's sight in a frame.
    """
    seconds = np.arange(len(motion)) / motion.frames_per_second
    offset, heading = camera.place(motion.root_position, motion.angles[:, 0], seconds)
    x = ANGLES.from_angles(np.column_stack([heading, motion.angles[:, 1:]]))
    lazy = LazyMasks(motion.name, body, camera, x, offset, degrade, held=held)
    masks: np.ndarray | LazyMasks = lazy
    if now:
        masks = np.empty((len(motion), camera.height, camera.width), np.uint8)
        for frame, mask in enumerate(replace(lazy, held=False)):
            masks[frame] = mask
            advance(1)
    return Take(
        name or motion.name,
        motion.performer,
        motion.frames_per_second,
        x,
        masks,
        offset,
        source=motion.name,
        camera=camera,
    )


@dataclass
class Renderer:
    """Motion, and what it is rendered with.

    Attributes
    ----------
    source : MotionSource
    body : Body
        The body of validation and test.
    camera : Camera
        The camera of validation and test.
    scenes : SceneSampler
        Bodies and cameras of training.
    degradation : Degradation
        Degradation of the masks, by default none.

    Examples
    --------
    A dataset in small images, of walkers drawn from a statistical model:

    >>> from silpose.dataset import Renderer, SamePerformer
    >>> from silpose.motion import WalkerTakes
    >>> from silpose.silhouette import Camera
    >>> walkers = WalkerTakes(seconds=1, test_seconds=1)
    >>> dataset = SamePerformer().load(Renderer(walkers, camera=Camera(width=64, height=64)))
    >>> dataset.test[0].masks.shape
    (15, 64, 64)
    """

    source: MotionSource
    body: Body = field(default_factory=Body)
    camera: Camera = field(default_factory=Camera)
    scenes: SceneSampler = field(default_factory=SceneSampler)
    degradation: Degradation = field(default_factory=Degradation)

    @property
    def takes(self) -> Sequence[Motion]:
        """All motion of the source."""
        return self.source.takes()

    def render(
        self, train: Sequence[Scene], validation: Sequence[Scene], test: Sequence[Scene]
    ) -> tuple[list[Take], list[Take], list[Take]]:
        """Render the scenes of a dataset, degraded as `degradation` is set.

        Parameters
        ----------
        train, validation, test : sequence of Scene

        Returns
        -------
        train, validation, test : list of Take
            The masks of training are rendered when they are first asked for, since descriptors
            may be known; they stay in memory unless they need more than `HELD`.
        """
        frames = sum(len(scene.motion) for scene in train)
        held = frames * self.camera.height * self.camera.width <= HELD
        eager = [*validation, *test]
        hurt = self.degradation
        with bar("masks", sum(len(scene.motion) for scene in eager)) as advance:
            return (
                [self._render(scene, hurt.train, now=False, held=held) for scene in train],
                [self._render(scene, hurt.train, advance=advance) for scene in validation],
                [self._render(scene, hurt.test, advance=advance) for scene in test],
            )

    def _render(self, scene: Scene, kinds: Sequence[str], **how: Any) -> Take:
        return render_take(
            scene.motion,
            scene.body,
            scene.camera,
            name=scene.name,
            degrade=self.degradation.degrader(kinds, scene.name),
            **how,
        )

    def rerender(self, takes: Sequence[Take], scenes: SceneSampler) -> list[Take]:
        """Render the motion of some takes again, in other scenes and without degradation.

        Parameters
        ----------
        takes : sequence of Take
            Rendered from this renderer's motion.
        scenes : SceneSampler

        Returns
        -------
        takes : list of Take
        """
        sources = {take.source for take in takes}
        motions = [motion for motion in self.takes if motion.name in sources]
        drawn = scenes.draw(motions, self.body, self.camera, stream=3)
        return [render_take(s.motion, s.body, s.camera, name=s.name) for s in drawn]

"""The split by camera and body: those of the test are outside the ranges of the training."""

from __future__ import annotations

from collections.abc import Sequence

from silpose.core.errors import InputError
from silpose.dataset.same_performer import SamePerformer
from silpose.dataset.scenes import SceneSampler
from silpose.silhouette import Body, Camera


class CrossCamera(SamePerformer):
    """Assign takes by name, and give the test takes cameras and bodies never trained on.

    Parameters
    ----------
    train, validation, test, usual_validation, usual_test
        As in `SamePerformer`.
    elevation, focal_length, shape : list of 2 floats
        Ranges of the test, as in `SceneSampler`; none may meet that of the training.
    """

    def __init__(
        self,
        train: list[str] | None = None,
        validation: list[str] | None = None,
        test: list[str] | None = None,
        usual_validation: Sequence[str] = ("validation", "*spiral_walk_normal08"),
        usual_test: Sequence[str] = ("test", "*spiral_walk_fast12"),
        elevation: Sequence[float] = (25.0, 35.0),
        focal_length: Sequence[float] = (1.3, 1.5),
        shape: Sequence[float] = (3.5, 4.5),
    ) -> None:
        super().__init__(train, validation, test, usual_validation, usual_test)
        self.elevation = list(elevation)
        self.focal_length = list(focal_length)
        self.shape = list(shape)

    def test_scenes(self, training: SceneSampler, body: Body, camera: Camera) -> SceneSampler:
        """Give the ranges of the test, outside those of the training."""
        strange = SceneSampler(
            around=training.around,
            elevation=self.elevation,
            focal_length=self.focal_length,
            shape=self.shape,
            distance=training.distance,
            seed=training.seed,
        )
        for name in ("elevation", "focal_length", "shape"):
            low, high = training.range_of(name, body, camera)
            ends = getattr(strange, name)
            if ends[0] <= high and low <= ends[1]:
                raise InputError(
                    f"dataset.{name} {ends} of the test meets the training's [{low:g}, {high:g}]: "
                    f"move one of them or silhouette.scenes.{name}"
                )
        return strange

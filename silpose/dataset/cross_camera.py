"""The split by camera and body: those of the test are outside the ranges of the training."""

from __future__ import annotations

from collections.abc import Sequence

from silpose.core.errors import InputError
from silpose.dataset.same_performer import SamePerformer
from silpose.dataset.scenes import SceneSampler
from silpose.silhouette import Body, Camera


class CrossCamera(SamePerformer):
    """Split by take, and test with cameras and bodies that are not in training.

    Parameters
    ----------
    train : list of str or None, default=None
        Names of takes, or globs. Takes that are in no list are of training, too.
    validation, test : list of str or None, default=None
        Names of takes, or globs. None chooses the usual takes below if there are any, else one of
        the last takes.
    usual_validation : sequence of str, default=("validation", "*spiral_walk_normal08")
        Globs of takes that are customary for validation.
    usual_test : sequence of str, default=("test", "*spiral_walk_fast12")
        Globs of takes that are customary for testing.
    elevation : sequence of 2 floats, default=(25.0, 35.0)
        Range of the test cameras' elevations, degrees; as the other ranges, it must not meet that
        of the training, which is in `SceneSampler`.
    focal_length : sequence of 2 floats, default=(1.3, 1.5)
        Range of the test cameras' focal lengths, image heights.
    shape : sequence of 2 floats, default=(3.5, 4.5)
        Range of the lengths of the test bodies' shape coefficients, standard deviations.
    """

    name = "cross_camera"

    def __init__(
        self,
        *,
        train: list[str] | None = None,
        validation: list[str] | None = None,
        test: list[str] | None = None,
        usual_validation: Sequence[str] = ("validation", "*spiral_walk_normal08"),
        usual_test: Sequence[str] = ("test", "*spiral_walk_fast12"),
        elevation: Sequence[float] = (25.0, 35.0),
        focal_length: Sequence[float] = (1.3, 1.5),
        shape: Sequence[float] = (3.5, 4.5),
    ) -> None:
        super().__init__(
            train=train,
            validation=validation,
            test=test,
            usual_validation=usual_validation,
            usual_test=usual_test,
        )
        self.elevation = list(elevation)
        self.focal_length = list(focal_length)
        self.shape = list(shape)

    def test_scenes(self, training: SceneSampler, body: Body, camera: Camera) -> SceneSampler:
        """Scenes of the test, outside the ranges of the training.

        Raises
        ------
        InputError
            If a range of the test meets that of the training.
        """
        unseen = SceneSampler(
            around=training.around,
            elevation=self.elevation,
            focal_length=self.focal_length,
            shape=self.shape,
            distance=training.distance,
            seed=training.seed,
        )
        for name in ("elevation", "focal_length", "shape"):
            low, high = training.range_of(name, body, camera)
            ends = getattr(unseen, name)
            if ends[0] <= high and low <= ends[1]:
                raise InputError(
                    f"dataset.{name} {ends} of the test meets the training's [{low:g}, {high:g}]: "
                    f"move one of them or silhouette.scenes.{name}"
                )
        return unseen

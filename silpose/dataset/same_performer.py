"""The split by take: the same performers are in training and test, in different takes."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from silpose.core.errors import InputError
from silpose.dataset.splitter import Split, Splitter, matching


class SamePerformer(Splitter):
    """Split by take: takes are assigned to training, validation and test by name.

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
    """

    name = "same_performer"

    def __init__(
        self,
        *,
        train: list[str] | None = None,
        validation: list[str] | None = None,
        test: list[str] | None = None,
        usual_validation: Sequence[str] = ("validation", "*spiral_walk_normal08"),
        usual_test: Sequence[str] = ("test", "*spiral_walk_fast12"),
    ) -> None:
        self.train = train
        self.validation = validation
        self.test = test
        self.usual_validation = usual_validation
        self.usual_test = usual_test

    def split(self, performers: Collection[str]) -> Split:
        """Assign every take to training, validation or test.

        Parameters
        ----------
        performers : collection of str
            Names of the takes, in order, such as the keys of a mapping to performers.

        Returns
        -------
        split : Split

        Raises
        ------
        InputError
            If a glob matches nothing, lists overlap, or a part would be empty.
        """
        takes = list(performers)
        if len(takes) < 3:
            raise InputError(
                f"a split into training, validation and test needs at least 3 takes, "
                f"not {len(takes)}: {', '.join(takes)}"
            )
        train = [] if self.train is None else self._named(takes, "train", self.train)
        test = self._held_out(takes, "test", self.test, self.usual_test, train)
        validation = self._held_out(
            takes, "validation", self.validation, self.usual_validation, [*train, *test]
        )
        for take in takes:
            lists = [take in part for part in (train, validation, test)]
            if sum(lists) > 1:
                raise InputError(f"take '{take}' is in two of dataset.train, .validation, .test")
        train = [t for t in takes if t not in validation and t not in test]
        if not train:
            raise InputError("no take is left to train on: name fewer in dataset.validation, .test")
        return Split(train, validation, test)

    def _held_out(
        self,
        takes: Sequence[str],
        part: str,
        globs: Sequence[str] | None,
        usual: Sequence[str],
        taken: Sequence[str],
    ) -> list[str]:
        if globs is not None:
            return self._named(takes, part, globs)
        free = [t for t in takes if t not in taken]
        if not free:
            raise InputError(f"no take is left for dataset.{part}: name fewer in the other lists")
        return matching(free, usual) or free[-1:]

    def _named(self, takes: Sequence[str], part: str, globs: Sequence[str]) -> list[str]:
        for glob in globs:
            if not matching(takes, [glob]):
                raise InputError(
                    f"no take matches '{glob}' in dataset.{part}; the takes are {', '.join(takes)}"
                )
        return matching(takes, globs)

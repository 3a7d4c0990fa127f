"""The split by take: the same performers train and test, in different takes."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase

from silpose.core.errors import InputError


@dataclass(frozen=True)
class Split:
    """Names of the takes that train, validate and test.

    Attributes
    ----------
    train, validation, test : list of str
    by_performer : bool
        Whether no performer may be in two of them.
    """

    train: list[str]
    validation: list[str]
    test: list[str]
    by_performer: bool = False


class SamePerformer:
    """Assign takes to training, validation and test by name.

    Parameters
    ----------
    train, validation, test : list of str, or None
        Names of takes, or globs. A take that no list names goes to training. Where
        `validation` or `test` is None, the usual ones below are taken if there are such takes,
        else one of the last takes.
    usual_validation, usual_test : list of str
        Globs of takes that customarily validate and test.
    """

    def __init__(
        self,
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

    def split(self, takes: Collection[str]) -> Split:
        """Assign every take.

        Parameters
        ----------
        takes : collection of str
            Names, in order.

        Returns
        -------
        split : Split
        """
        takes = list(takes)
        if len(takes) < 3:
            raise InputError(
                f"a split into training, validation and test needs 3 takes or more, "
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
            raise InputError(f"no take is left for dataset.{part}")
        return _matching(free, usual) or free[-1:]

    def _named(self, takes: Sequence[str], part: str, globs: Sequence[str]) -> list[str]:
        for glob in globs:
            if not _matching(takes, [glob]):
                raise InputError(
                    f"no take matches '{glob}' in dataset.{part}; the takes are {', '.join(takes)}"
                )
        return _matching(takes, globs)


def _matching(takes: Sequence[str], globs: Sequence[str]) -> list[str]:
    return [t for t in takes if any(fnmatchcase(t, glob) for glob in globs)]

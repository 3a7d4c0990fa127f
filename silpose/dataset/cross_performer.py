"""The split by performer: those who test are strangers to those who train."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fnmatch import fnmatchcase

from silpose.core.errors import InputError
from silpose.dataset.same_performer import Split


class CrossPerformer:
    """Assign takes to training and test by who performs; settings are chosen without validation.

    Hyper-parameters are chosen by leaving one training performer out at a time.

    Parameters
    ----------
    test : list of str
        Performers, or globs, that test; all others train.
    """

    def __init__(self, test: Sequence[str] = ("08", "16", "29")) -> None:
        self.test = test

    def split(self, performers: Mapping[str, str]) -> Split:
        """Assign every take.

        Parameters
        ----------
        performers : mapping of str to str
            Take to performer, in order.

        Returns
        -------
        split : Split
        """
        known = sorted(set(performers.values()))
        for glob in self.test:
            if not any(fnmatchcase(performer, glob) for performer in known):
                raise InputError(
                    f"no performer matches '{glob}' in dataset.test; there are {', '.join(known)} "
                    "(motion.performer says how they are told)"
                )
        strangers = [p for p in known if any(fnmatchcase(p, glob) for glob in self.test)]
        if len(known) - len(strangers) < 2:
            raise InputError(
                f"fewer than two performers are left to train: of {', '.join(known)} "
                f"{', '.join(strangers)} test; name fewer in dataset.test, or set motion.performer"
            )
        return Split(
            train=[take for take, p in performers.items() if p not in strangers],
            validation=[],
            test=[take for take, p in performers.items() if p in strangers],
            by_performer=True,
        )

"""The split by performer: the test is on unseen performers."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from silpose.core.errors import InputError
from silpose.dataset.splitter import Split, Splitter, matching
from silpose.motion import Motion


class CrossPerformer(Splitter):
    """Split by performer: those of the test are not in training.

    There is no validation: settings are chosen by leaving one training performer out at a time.
    Without ``silhouette.scenes.frames``, training has as many frames of every performer as the one
    with the fewest has.

    Parameters
    ----------
    test : sequence of str, default=("08", "16", "29")
        Performers of the test, or globs; all others are of training.
    """

    name = "cross_performer"
    by_performer = True

    def __init__(self, test: Sequence[str] = ("08", "16", "29")) -> None:
        self.test = test

    def split(self, performers: Mapping[str, str]) -> Split:
        """Assign every take to training or test.

        Parameters
        ----------
        performers : mapping of str to str
            Take to performer, in order.

        Returns
        -------
        split : Split

        Raises
        ------
        InputError
            If a glob matches nothing, or fewer than two performers are left for training.
        """
        known = sorted(set(performers.values()))
        for glob in self.test:
            if not matching(known, [glob]):
                raise InputError(
                    f"no performer matches '{glob}' in dataset.test; there are {', '.join(known)} "
                    "(motion.performer finds them in the files' paths)"
                )
        unseen = matching(known, self.test)
        if len(known) - len(unseen) < 2:
            raise InputError(
                f"fewer than two performers are left to train on: of {', '.join(known)} "
                f"{', '.join(unseen)} are of the test; name fewer in dataset.test, "
                "or set motion.performer"
            )
        return Split(
            train=[take for take, performer in performers.items() if performer not in unseen],
            validation=[],
            test=[take for take, performer in performers.items() if performer in unseen],
        )

    def check(self, takes: Sequence[Motion]) -> None:
        """Refuse synthetic motion, whose model was fitted to all performers."""
        for take in takes:
            if take.synthetic:
                raise InputError(
                    f"take '{take.name}' is of the statistical walker, which was fitted to all "
                    "performers, so that none is unseen: add motion=bvh motion.root=FOLDER"
                )

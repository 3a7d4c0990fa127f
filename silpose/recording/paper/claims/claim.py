"""One claim of the paper."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from silpose.recording.paper.found import Found


@dataclass(frozen=True)
class Claim:
    """One claim, number or figure of the paper, and how it is compared with what was found.

    Attributes
    ----------
    section, item : str
        Where it stands: ``IV-B``, ``Fig. 8, table``.
    says : str
        What the paper says.
    number : str, default=""
        The paper's number.
    experiment : str or None, default=None
        The experiment that reproduces it; None where that cannot be done.
    ours : callable or None, default=None
        From a `Found` to our number, in words.
    holds : callable or None, default=None
        From a `Found` to whether it agrees with the claim; None where a picture is to be looked at.
    agrees, differs : str, default=""
        What to say if it does, and if it does not.
    reason : str, default=""
        Why it cannot be reproduced, or what it needs.
    """

    section: str
    item: str
    says: str
    number: str = ""
    experiment: str | None = None
    ours: Callable[[Found], str] | None = None
    holds: Callable[[Found], bool] | None = None
    agrees: str = ""
    differs: str = ""
    reason: str = ""

    def verdict(self, found: Found | None) -> tuple[str, str]:
        """One word, and a sentence.

        Parameters
        ----------
        found : Found or None
            What the experiment found; None if it has not run.

        Returns
        -------
        word : str
            ``reproduced``, ``differs``, ``shown``, ``cannot be had`` or ``not run``.
        sentence : str
        """
        if self.experiment is None:
            return "cannot be had", self.reason
        if found is None:
            return "not run", self.reason or f"`silpose experiment={self.experiment}` has not run."
        if self.holds is None:
            return "shown", self.agrees
        return ("reproduced", self.agrees) if self.holds(found) else ("differs", self.differs)

"""What the paper claims, section by section, and how a run tells whether it holds."""

from silpose.recording.paper.claims.claim import Claim
from silpose.recording.paper.claims.descriptor import DESCRIPTOR
from silpose.recording.paper.claims.mixtures import MIXTURES
from silpose.recording.paper.claims.regression import REGRESSION
from silpose.recording.paper.claims.single_image import INTRODUCTION, SINGLE_IMAGE
from silpose.recording.paper.claims.tracking import TRACKING

CLAIMS: tuple[Claim, ...] = (
    *INTRODUCTION, *DESCRIPTOR, *REGRESSION, *SINGLE_IMAGE, *TRACKING, *MIXTURES
)  # fmt: skip
"""All claims, in the paper's order."""

__all__ = ["CLAIMS", "Claim"]

"""The paper beside what was reproduced of it: its claims, and the report of a run of them all."""

from silpose.recording.paper.claims import CLAIMS, Claim
from silpose.recording.paper.found import Found
from silpose.recording.paper.report import PaperReport, write_paper

__all__ = ["CLAIMS", "Claim", "Found", "PaperReport", "write_paper"]

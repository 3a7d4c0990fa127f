"""``silpose paper``: every experiment of the paper, one after the other, and one report of them."""

from silpose.app.paper.options import PaperOptions, parse
from silpose.app.paper.runner import run_paper

__all__ = ["PaperOptions", "parse", "run_paper"]

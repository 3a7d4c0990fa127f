import re
from pathlib import Path

from silpose.experiments import CATALOGUE
from silpose.experiments.catalogue import Entry

PAGE = Path(__file__).parents[2] / "docs" / "paper.md"


def test_the_documentation_asks_the_same_questions():
    rows = re.findall(r"^\| (`\w+`(?:, `\w+`)*) \| (.+?) \|", PAGE.read_text("utf-8"), re.M)
    asked = {
        name: re.sub(r" \(`.*?`\)$", "", question)
        for names, question in rows
        for name in re.findall(r"\w+", names)
        if name in CATALOGUE
    }
    assert asked == {name: entry.question for name, entry in CATALOGUE.items()}


def test_every_experiment_asks_something():
    for entry in CATALOGUE.values():
        assert entry.question.endswith("?")
        assert Entry("").table and entry.table and entry.rows

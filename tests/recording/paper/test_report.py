import re

from silpose.evaluation import BASELINES
from silpose.recording.paper import CLAIMS, Found, PaperReport, write_paper

ERRORS = {"mean_angular_error_deg": 3.0}
PIXEL = bytes.fromhex(
    "89504e470d0a1a0a0000000d4948445200000001000000010806000000"
    "1f15c4890000000d49444154789c6360000002000001e221bc330000000049454e44ae426082"
)


def report_of(tmp_path, *runs, failed=()):
    found = {run.experiment: Found([run]) for run in runs}
    return PaperReport({"walkers": found}, {}, dict(failed), tmp_path, "read <this> first")


def test_every_claim_stands_in_both_files(finished_run, tmp_path):
    run = finished_run("bridges", {"rvm": {"kept": 0.1, "iterations": 20}})
    (run.folder / "bridges.png").write_bytes(PIXEL)
    page, text = write_paper(report_of(tmp_path, run))
    html, markdown = page.read_text(), text.read_text()
    assert html.count("<article>") == len(CLAIMS)
    assert markdown.count("\n**") == len(CLAIMS) + 1  # and the note
    assert "read &lt;this&gt; first" in html and "read <this> first" in markdown
    assert "![bridges](bridges/walkers/bridges.png)" in markdown


def test_the_page_needs_nothing_else(finished_run, tmp_path):
    run = finished_run("bridges", {"rvm": {"kept": 0.1, "iterations": 20}})
    (run.folder / "bridges.png").write_bytes(PIXEL)
    page, _ = write_paper(report_of(tmp_path, run))
    html = page.read_text()
    assert 'src="data:image/png;base64,' in html
    assert not re.search(r'(src|href)="(http|//)', html)


def test_a_failure_is_said_where_its_claims_are(tmp_path):
    page, _ = write_paper(report_of(tmp_path, failed={"walkers/bridges": "no space left"}.items()))
    told = sum(claim.experiment == "bridges" for claim in CLAIMS)
    assert page.read_text().count("It failed: no space left") == told


def test_values_that_the_data_do_not_give_leave_the_claim_without_a_number(finished_run, tmp_path):
    run = finished_run("regressors", {"ridge kernel": ERRORS})
    report = report_of(tmp_path, run)
    assert report.counts()["not run"] == sum(1 for c in CLAIMS if c.experiment)


def test_commands_in_sentences_are_code_in_the_page(tmp_path):
    html, markdown = (path.read_text() for path in write_paper(report_of(tmp_path)))
    assert "<code>silpose experiment=bridges</code> has not run" in html
    assert "`silpose experiment=bridges` has not run" in markdown


def test_baselines_are_told_once_in_a_section(finished_run, tmp_path):
    errors = {name: ERRORS for name in ("ridge kernel", "ridge linear", *BASELINES)}
    run = finished_run("regressors", errors)
    for title, claims in report_of(tmp_path, run).sections():
        own = [claim for claim in claims if claim["experiment"] == "regressors"]
        assert sum(bool(claim["baselines"]) for claim in own) <= 1, title
        assert not title.startswith("III-A") or any(claim["baselines"] for claim in own)

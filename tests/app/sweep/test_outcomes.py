import pytest

from silpose.app.sweep.outcomes import outcomes, spreads
from silpose.recording import Result, RunFolder, write_result
from silpose.recording.runs.sweep_folder import write_definition, write_failure


@pytest.fixture
def sweep(tmp_path):
    """Runs of two widths and two seeds, beside one that failed and one that was cut off."""
    folder = tmp_path / "e" / "s"
    write_definition(folder, {"varied": ["width", "descriptor", "seed"]})
    for width, seed in ((10, 0), (2, 0), (10, 1), (2, 1)):
        settings = f"{{width: {width}, seed: {seed}, descriptor: {{radius: 1}}}}"
        name = f"width_{width}-descriptor_robust-seed_{seed}"
        run = RunFolder.start("e", settings, root=tmp_path, sweep="s", name=name)
        metrics = {"ridge": {"error": width + seed}}
        write_result(run, Result("walker", metrics, headline=width), seed, {})
    write_failure(folder / "failed", "a full disk", "Traceback")
    RunFolder.start("e", root=tmp_path, sweep="s", name="cut_off")
    return folder


def test_runs_are_sorted_by_what_they_vary_and_failures_come_last(sweep):
    found = outcomes(sweep)
    assert [each.varied.get("width") for each in found] == [2, 2, 10, 10, None, None]
    assert [each.varied.get("seed") for each in found][:4] == [0, 1, 0, 1]
    assert [each.reason for each in found] == ["", "", "", "", "not finished", "a full disk"]
    assert found[0].values == {"ridge.error": 2}


def test_seeds_are_averaged(sweep):
    (narrow, count, values), (wide, *_) = spreads(outcomes(sweep))
    assert (narrow["width"], wide["width"], count) == (2, 10, 2)
    assert values["ridge.error"] == pytest.approx((2.5, 0.5**0.5))

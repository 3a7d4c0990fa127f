import pytest

from silpose.recording.paper import Found


def test_several_seeds_have_a_mean_and_a_spread(finished_run):
    runs = [
        finished_run("tracking", {"rvm": {"mean_angular_error_deg": e, "kept": 0.2}}, name=str(e))
        for e in (3.0, 4.0)
    ]
    assert Found(runs).words("rvm") == "3.50 ± 0.71°"
    assert Found(runs).words("rvm", "kept", percent=True) == "20 ± 0%"
    assert Found(runs[:1]).words("rvm") == "3.00°"


def test_distances_have_no_unit(finished_run):
    found = Found([finished_run("tracking", {"rvm": {"mean_joint_distance": 2.5}})])
    assert found.words("rvm") == "2.50"


def test_what_is_missing_is_a_lookup_error(finished_run):
    found = Found([finished_run("tracking", {"rvm": {"kept": 0.2}})])
    for missing in ("rvm", "svm"):
        with pytest.raises(LookupError):
            found.value(missing)


def test_rows_are_found_by_their_values(finished_run):
    run = finished_run("parts", {}, rows="method,kept\nrvm,0.1\nsvm,0.5\n")
    assert Found([run]).row(method="svm") == {"method": "svm", "kept": "0.5"}

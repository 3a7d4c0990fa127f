from silpose.app.sweep.run_name import run_name


def test_a_name_says_what_varies():
    overrides = ["experiment=tracking", "regression.rvm.nu=0.3", "seed=1"]
    assert run_name(overrides, ["regression.rvm.nu", "seed"]) == "nu_0.3-seed_1"
    assert run_name(overrides, []) == "only"


def test_settings_of_one_name_are_told_apart():
    overrides = ["regression.basis.width=1", "tracking.tracker.width=2"]
    varied = ["regression.basis.width", "tracking.tracker.width"]
    assert run_name(overrides, varied) == "regression.basis.width_1-tracking.tracker.width_2"


def test_no_two_runs_have_the_same_name_and_any_is_a_folder():
    values = ["/a/b", "a/b", "[1, 2]", "[1,2]", "'x y'", "ü" * 300, "ü" * 301]
    names = [run_name([f"model={value}"], ["model"]) for value in values]
    assert len(set(names)) == len(names)
    assert all("/" not in name and len(name) < 100 for name in names)

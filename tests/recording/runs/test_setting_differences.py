from silpose.recording.runs.setting_differences import differing, parsed


def test_only_what_differs_is_kept():
    first = {"seed": 0, "ridge": {"damping": 0.1}, "recording": {"name": "a"}}
    second = {"seed": 0, "ridge": {"damping": [0.1, 1]}, "recording": {"name": "b"}, "nu": 3}
    assert differing([first, second]) == [
        {"ridge.damping": 0.1, "nu": None},
        {"ridge.damping": [0.1, 1], "nu": 3},
    ]
    assert differing([first, first]) == [{}, {}]
    assert differing([]) == []


def test_seeds_that_follow_the_runs_seed_are_no_difference():
    runs = [
        {"seed": k, "motion": {"seed": k}, "rvm": {"random_state": k}, "scenes": {"seed": 5 - k}}
        for k in range(2)
    ]
    assert differing(runs) == [{"seed": 0, "scenes.seed": 5}, {"seed": 1, "scenes.seed": 4}]


def test_settings_that_are_no_yaml_are_empty():
    assert parsed("seed: 3") == {"seed": 3}
    assert parsed("{") == {}

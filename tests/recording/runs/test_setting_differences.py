from silpose.recording.runs.setting_differences import differing


def test_only_what_differs_is_kept():
    first = {"seed": 0, "ridge": {"damping": 0.1}, "recording": {"name": "a"}}
    second = {"seed": 0, "ridge": {"damping": [0.1, 1]}, "recording": {"name": "b"}, "nu": 3}
    assert differing([first, second]) == [
        {"ridge.damping": 0.1, "nu": None},
        {"ridge.damping": [0.1, 1], "nu": 3},
    ]
    assert differing([first, first]) == [{}, {}]
    assert differing([]) == []

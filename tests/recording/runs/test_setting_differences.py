from silpose.recording.runs.setting_differences import differing, flat, typed


def test_names_are_those_of_the_command_line():
    settings = {"seed": 0, "regression": {"rvm": {"nu": [3, 10]}}, "values": None}
    assert dict(flat(settings)) == {"seed": 0, "regression.rvm.nu": [3, 10], "values": None}
    assert [typed(value) for _, value in flat(settings)] == ["0", "[3, 10]", "null"]


def test_only_what_differs_is_told():
    first = {"seed": 0, "ridge": {"damping": 0.1}, "recording": {"name": "a"}}
    second = {"seed": 0, "ridge": {"damping": [0.1, 1]}, "recording": {"name": "b"}, "nu": 3}
    assert differing([first, second]) == [
        {"ridge.damping": 0.1, "nu": None},
        {"ridge.damping": [0.1, 1], "nu": 3},
    ]
    assert differing([first, first]) == [{}, {}]
    assert differing([]) == []

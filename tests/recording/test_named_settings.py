from silpose.recording.named_settings import flat, typed


def test_names_are_those_of_the_command_line():
    settings = {"seed": 0, "regression": {"rvm": {"nu": [3, 10]}}, "values": None}
    assert dict(flat(settings)) == {"seed": 0, "regression.rvm.nu": [3, 10], "values": None}
    assert [typed(value) for _, value in flat(settings)] == ["0", "[3, 10]", "null"]

from silpose.core.readable import readable


def test_bytes_that_are_no_character_become_question_marks():
    assert readable(b"\xe4 w\xc3\xa4".decode(errors="surrogateescape")) == "? wä"

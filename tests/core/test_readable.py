from silpose.core.readable import readable


def test_bytes_that_are_no_character_are_written_as_numbers():
    names = [
        name.decode(errors="surrogateescape") for name in (b"\xe4 w\xc3\xa4", b"\xf6 w\xc3\xa4")
    ]
    assert [readable(name) for name in names] == ["\\xe4 wä", "\\xf6 wä"]
    assert readable("plain ä °") == "plain ä °"
    assert readable("half \ud800") == "half ?"


def test_a_name_is_whole_again_that_a_terminal_of_ascii_took_to_pieces():
    assert readable("Jürgen".encode().decode("ascii", errors="surrogateescape")) == "Jürgen"

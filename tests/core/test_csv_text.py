from silpose.core.csv_text import csv_text


def test_values_with_commas_and_quotes_are_quoted():
    assert csv_text([["frame", "file"], [0, 'a,"b".png']]) == 'frame,file\n0,"a,""b"".png"\n'

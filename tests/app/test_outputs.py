import io
import os
import subprocess
import sys
from pathlib import Path

import pytest

from silpose.app.outputs import print_anywhere

SILPOSE = f"{sys.executable} -m silpose.app.main"


def test_a_terminal_that_is_not_utf_8_shows_question_marks(monkeypatch):
    shown = io.BytesIO()
    monkeypatch.setattr("sys.stdout", io.TextIOWrapper(shown, encoding="ascii"))
    monkeypatch.setattr("sys.stderr", sys.stderr)
    print_anywhere()
    print("2.6° of θ", flush=True)
    assert shown.getvalue() == b"2.6? of ?\n"


def test_output_that_nobody_reads_is_no_error():
    command = f"{SILPOSE} --help".split()
    code = f"import subprocess; p = subprocess.Popen({command!r}, stdout=subprocess.PIPE); "
    code += "p.stdout.close(); raise SystemExit(p.wait())"
    shown = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert (shown.returncode, shown.stderr) == (0, "")


@pytest.mark.skipif(os.name != "posix", reason="closes outputs by a shell")
@pytest.mark.parametrize(
    ("redirected", "status", "said"),
    [
        (">&-", 0, ""),
        ("<&- >&- 2>&-", 0, ""),
        ("2>/dev/full", 0, ""),
        (">/dev/full", 1, "silpose: the standard output cannot be written (No space left on "),
    ],
)
def test_outputs_that_are_closed_or_full(redirected, status, said, tmp_path):
    """The words of one line, the exit status, and no traceback when Python ends."""
    if "full" in redirected and not Path("/dev/full").exists():
        pytest.skip("there is no /dev/full here")
    command = f"{SILPOSE} list . {redirected}"
    shown = subprocess.run(["sh", "-c", command], capture_output=True, text=True, cwd=tmp_path)
    assert shown.returncode == status
    assert shown.stderr.startswith(said) and shown.stderr.count("\n") == bool(said)


def test_a_file_does_not_get_the_number_of_an_output_that_was_closed(tmp_path):
    code = (
        "from silpose.app.outputs import print_anywhere; print_anywhere(); import os; "
        "file = open('kept', 'w'); os.write(1, b'from another program'); file.close()"
    )
    subprocess.run(["sh", "-c", f'{sys.executable} -c "{code}" >&-'], cwd=tmp_path, check=True)
    assert (tmp_path / "kept").read_text() == ""

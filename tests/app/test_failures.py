import io
import subprocess
import sys

import pytest

from silpose.app import main as command
from silpose.app.failures import INTERRUPTED, print_anywhere, sentence
from silpose.core.errors import InputError

WORDS = {
    "silpose: give another": InputError("give another"),
    "silpose: not enough memory: use fewer": MemoryError(),
    "silpose: not enough memory: ": ImportError("a.so: failed to map segment from shared object"),
    "silpose: 'a.csv': Permission denied": PermissionError(13, "Permission denied", "a.csv"),
    "silpose: Too many open files (raise the limit by": OSError(24, "Too many open files"),
    "silpose: unexpected KeyError: 'a' (debug=true": KeyError("a"),
    "silpose: unexpected ValueError: two lines (debug=true": ValueError("two\nlines"),
}


@pytest.mark.parametrize("words", WORDS)
def test_every_failure_is_one_sentence(words):
    said = sentence(WORDS[words])
    assert said.startswith(words) and "\n" not in said


def test_ctrl_c_is_one_line_and_a_status_of_its_own(monkeypatch, capsys):
    def interrupted(arguments):
        raise KeyboardInterrupt

    monkeypatch.setattr(command, "_run", interrupted)
    with pytest.raises(SystemExit) as stop:
        command.main()
    assert stop.value.code == INTERRUPTED == 130
    assert capsys.readouterr().err == "silpose: interrupted\n"


def test_a_terminal_that_is_not_utf_8_shows_question_marks(monkeypatch):
    shown = io.BytesIO()
    monkeypatch.setattr("sys.stdout", io.TextIOWrapper(shown, encoding="ascii"))
    print_anywhere()
    print("2.6° of θ", flush=True)
    assert shown.getvalue() == b"2.6? of ?\n"


def test_output_that_nobody_reads_is_no_error():
    command = f"{sys.executable} -m silpose.app.main --help"
    code = f"import subprocess; p = subprocess.Popen({command.split()!r}, stdout=subprocess.PIPE); "
    code += "p.stdout.close(); raise SystemExit(p.wait())"
    shown = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert (shown.returncode, shown.stderr) == (0, "")

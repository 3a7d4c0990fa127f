import pytest

from silpose.app import main as command
from silpose.app.failures import INTERRUPTED, sentence
from silpose.core.errors import InputError

WORDS = {
    "silpose: give another": InputError("give another"),
    "silpose: not enough memory: use fewer": MemoryError(),
    "silpose: not enough memory: ": ImportError("a.so: failed to map segment from shared object"),
    "silpose: not enough memory: use": OSError("Could not find/load shared object file 'a.so'"),
    "silpose: 'a.csv': Permission denied": PermissionError(13, "Permission denied", "a.csv"),
    "silpose: Too many open files (raise the limit by": OSError(24, "Too many open files"),
    "silpose: the current folder is no longer there": FileNotFoundError(2, "No such file"),
    "silpose: unexpected KeyError: 'a' (debug=true": KeyError("a"),
    "silpose: unexpected ValueError: two lines (debug=true": ValueError("two\nlines"),
}


@pytest.mark.parametrize("words", WORDS)
def test_every_failure_is_one_sentence(words):
    said = sentence(WORDS[words])
    assert said.startswith(words) and "\n" not in said


def test_files_that_a_run_keeps_are_named():
    error = MemoryError()
    error.add_note("'recordings/a/001' keeps model.npz")
    assert sentence(error).endswith("n_jobs; 'recordings/a/001' keeps model.npz")


def test_ctrl_c_is_one_line_and_a_status_of_its_own(monkeypatch, capsys):
    def interrupted(arguments):
        raise KeyboardInterrupt

    monkeypatch.setattr(command, "_run", interrupted)
    with pytest.raises(SystemExit) as stop:
        command.main()
    assert stop.value.code == INTERRUPTED == 130
    assert capsys.readouterr().err == "silpose: interrupted\n"

import shutil
import subprocess

import pytest

from silpose.app.commands import TOOLS
from silpose.app.completion import completion_script
from silpose.app.verbs import EXPERIMENT_VERBS

BASH = shutil.which("bash")


def completed(folder, *words):
    asked = " ".join(f"'{word}'" for word in words)
    script = completion_script("bash", tuple(EXPERIMENT_VERBS), tuple(TOOLS))
    script += f"\nCOMP_WORDS=({asked}); COMP_CWORD={len(words) - 1}; _silpose\n"
    script += 'printf "%s\\n" "${COMPREPLY[@]}"\n'
    shown = subprocess.run([BASH, "-c", script], cwd=folder, capture_output=True, text=True)
    return shown.stdout.split()


@pytest.mark.skipif(BASH is None, reason="needs bash")
def test_commands_choices_and_runs_are_completed(tmp_path):
    (tmp_path / "recordings/tracking/001").mkdir(parents=True)
    assert completed(tmp_path, "silpose", "pi") == ["picture"]
    assert completed(tmp_path, "silpose", "exp") == ["experiment="]
    assert completed(tmp_path, "silpose", "experiment", "=", "tr") == ["tracking", "training_data"]
    assert completed(tmp_path, "silpose", "seed=1", "motion", "=") == ["amass", "bvh", "walker"]
    assert completed(tmp_path, "silpose", "open", "rec") == ["recordings/tracking/001"]
    assert completed(tmp_path, "silpose", "predict", "pi") == []  # files, by the shell itself


def test_zsh_reads_it_too():
    script = completion_script("zsh", ("predict",), ("list",))
    assert script.startswith("autoload -U +X compinit bashcompinit")

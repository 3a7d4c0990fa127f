"""The command: ``silpose VERB [PATH …] [key=value …]``, or Hydra's form without a verb."""

from __future__ import annotations

import gc
import os
import sys
import warnings
from collections.abc import Sequence

from silpose.app.commands import TOOLS, run_tool
from silpose.app.conf_folder import groups
from silpose.app.failures import INTERRUPTED, sentence
from silpose.app.outputs import print_anywhere, stop_quietly
from silpose.app.suggestions import nearest
from silpose.app.verbs import EXPERIMENT_VERBS, help_text, overrides_of, verb_help
from silpose.core.errors import InputError
from silpose.core.stages import stage


def main() -> None:
    """Run ``silpose`` from the command line; what goes wrong is one sentence."""
    os.environ["HYDRA_FULL_ERROR"] = "1"  # so that Hydra leaves its errors to us
    warnings.showwarning = lambda message, *_: print(f"silpose: {message}", file=sys.stderr)
    # joblib starts a process anew that has grown: nothing is lost, and nothing can be done.
    warnings.filterwarnings("ignore", "A worker stopped while some jobs")
    print_anywhere()
    try:
        _run(sys.argv[1:])
        sys.stdout.flush()
        gc.freeze()  # the process ends: looking for garbage once more would take a second
    except KeyboardInterrupt:
        print("silpose: interrupted", file=sys.stderr)
        raise SystemExit(INTERRUPTED) from None
    except BrokenPipeError:
        stop_quietly()
    except Exception as error:
        if "debug=true" in sys.argv:
            raise
        raise SystemExit(sentence(error)) from None


def _run(arguments: Sequence[str]) -> None:
    verb = arguments[0] if arguments else ""
    if verb in TOOLS:
        run_tool([argument for argument in arguments if argument != "debug=true"])
    elif verb in EXPERIMENT_VERBS and arguments[1:2] in (["-h"], ["--help"]):
        print(verb_help(verb))
    elif verb in EXPERIMENT_VERBS:
        _run_hydra(overrides_of(verb, arguments[1:]))
    elif verb and "=" not in verb and not verb.startswith(("-", "+", "~")):
        if verb in groups()["experiment"]:
            rest = "".join(f" {argument}" for argument in arguments[1:])
            raise InputError(f"'{verb}' is an experiment: silpose experiment={verb}{rest}")
        known = (*EXPERIMENT_VERBS, *TOOLS)
        raise InputError(f"there is no command '{verb}'{nearest(verb, known)}")
    elif {"-h", "--help"} & set(arguments):
        print(help_text())
    elif "--version" in arguments:
        from silpose.recording.header import versions

        print(", ".join(f"{name} {version}" for name, version in versions().items()))
    else:
        _run_hydra(arguments)


def _run_hydra(arguments: Sequence[str]) -> None:
    # Heavy imports wait until there is something to do: --help answers at once.
    from silpose.core.stage_lines import stage_lines

    with stage_lines():
        with stage("loading"):
            from silpose.app.job import go_on_showing, run_job
            from silpose.app.sweep.command import is_sweep, run_sweep
            from silpose.app.typed_paths import with_paths_quoted

        overrides = [a for a in arguments if a[:1] in "+~" or ("=" in a and not a.startswith("-"))]
        options = [a for a in arguments if a not in overrides]
        sweep = is_sweep(options, overrides)
        overrides = with_paths_quoted(overrides, sweep)
        if sweep:
            run_sweep(options, overrides)
            return
        sys.argv[1:] = [*options, *overrides]  # where Hydra reads them, in this order only
        run_job()
        go_on_showing()


if __name__ == "__main__":
    main()

"""What the command says when it stops before its end, and its exit status."""

from __future__ import annotations

from silpose.core.errors import InputError

INTERRUPTED = 130
"""Exit status after Ctrl-C, as shells have it."""

_TOO_MANY_FILES = "raise the limit by 'ulimit -n 4096', or lower n_jobs"
_UNMAPPED = ("failed to map segment", "find/load shared object")  # the latter of llvmlite
_NO_MEMORY = "not enough memory: use fewer or shorter takes, smaller masks, or a lower n_jobs"


def sentence(error: Exception) -> str:
    """Say in one sentence what went wrong.

    Parameters
    ----------
    error : Exception

    Returns
    -------
    sentence : str
        An error that no input and no machine explains is called unexpected.
    """
    notes = getattr(error, "__notes__", [])  # which files a run keeps
    return "; ".join([f"silpose: {_what(error)}", *notes])


def _what(error: Exception) -> str:
    if isinstance(error, InputError):
        return str(error)
    if isinstance(error, MemoryError) or any(sign in str(error) for sign in _UNMAPPED):
        return _NO_MEMORY
    kind, words = type(error).__name__, " ".join(str(error).split())
    if isinstance(error, FileNotFoundError) and not error.filename:
        return "the current folder is no longer there: change to another one"
    if isinstance(error, OSError) and error.strerror:
        file = f"'{error.filename}': " if error.filename else ""
        remedy = f" ({_TOO_MANY_FILES})" if "open files" in error.strerror else ""
        return f"{file}{error.strerror}{remedy}"
    return f"unexpected {kind}: {words} (debug=true shows where it comes from)"

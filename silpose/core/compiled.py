"""Compiled functions, and when what is kept of them is compiled anew."""

from __future__ import annotations

import hashlib
import re
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any, TypeVar

from numba import njit

Function = TypeVar("Function", bound=Callable[..., Any])

_PACKAGE = Path(__file__).parents[1]
_IMPORTED = re.compile(r"^(?:from|import) silpose\.(\S+)", re.MULTILINE)


def compiled(**options: Any) -> Callable[[Function], Function]:
    """Compile a function when it is first called, and keep the result for the next program.

    Other threads go on while it runs. Numba compiles anew what is kept if the function's own
    module changed, but not if another one did, whose functions and constants are compiled in. So
    the function is kept under a name that tells of these, too.

    Parameters
    ----------
    **options
        Further options of `numba.njit`.

    Returns
    -------
    decorator : callable
    """

    def decorate(function: Function) -> Function:
        file = Path(sys.modules[function.__module__].__file__ or "")
        function.__qualname__ += f".{imported_code(file)}"
        compile_: Callable[[Function], Function] = njit(cache=True, nogil=True, **options)
        return compile_(function)

    return decorate


def imported_code(file: Path) -> str:
    """Name the source of a module of the package, and of all that it imports, directly or not.

    Packages other than those of `silpose.core` are left out: constants and compiled functions are
    imported from the modules that define them.

    Parameters
    ----------
    file : Path

    Returns
    -------
    digest : str
        8 characters.
    """
    sources: dict[Path, str] = {}
    _collect(file, sources)
    code = "\0".join(sources[each] for each in sorted(sources))
    return hashlib.sha256(code.encode()).hexdigest()[:8]


def _collect(file: Path, sources: dict[Path, str]) -> None:
    if file in sources or not file.is_file():
        return
    sources[file], imported = _read(file)
    for module in imported:
        path = _PACKAGE.joinpath(*module.split("."))
        _collect(path.with_suffix(".py"), sources)
        if path.is_relative_to(_PACKAGE / "core"):
            _collect(path / "__init__.py", sources)


@cache
def _read(file: Path) -> tuple[str, list[str]]:
    source = file.read_text(encoding="utf-8")
    return source, _IMPORTED.findall(source)

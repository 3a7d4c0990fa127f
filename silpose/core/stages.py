"""Stages of a run: the seconds that each takes, and who is told as they begin and end."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from contextvars import ContextVar
from functools import wraps
from time import perf_counter
from typing import ParamSpec, Protocol, TypeVar

Parameters = ParamSpec("Parameters")
Outcome = TypeVar("Outcome")


class Watcher(Protocol):
    """Who is told about stages."""

    def begin(self, name: str) -> None:
        """Show that a stage begins."""

    def end(self, name: str, failed: bool) -> None:
        """Show that it ends, perhaps by an error."""

    def counting(
        self, description: str, total: int
    ) -> AbstractContextManager[Callable[[int], None]]:
        """Count pieces of work within the stage that runs."""

    def close(self) -> None:
        """Leave what is shown: the run has ended."""


_seconds: ContextVar[dict[str, float] | None] = ContextVar("seconds", default=None)
_running: ContextVar[str | None] = ContextVar("running", default=None)
_watcher: ContextVar[Watcher | None] = ContextVar("watcher", default=None)


@contextmanager
def timing() -> Iterator[dict[str, float]]:
    """Collect the seconds of all stages that run inside.

    Yields
    ------
    seconds : dict of str to float
        By stage, filled as they end.
    """
    seconds: dict[str, float] = {}
    token = _seconds.set(seconds)
    try:
        yield seconds
    finally:
        _seconds.reset(token)
        if watcher := _watcher.get():
            watcher.close()


@contextmanager
def watched_by(watcher: Watcher) -> Iterator[None]:
    """Tell about all stages that run inside."""
    token = _watcher.set(watcher)
    try:
        yield
    finally:
        _watcher.reset(token)


def watcher_of_stage() -> Watcher | None:
    """Who is told about the stage that runs; None where none runs, or nobody is."""
    return None if _running.get() is None else _watcher.get()


@contextmanager
def stage(name: str) -> Iterator[None]:
    """Time what happens inside; a stage inside another one counts as part of that."""
    seconds, watcher = _seconds.get(), _watcher.get()
    if (seconds is None and watcher is None) or _running.get() is not None:
        yield
        return
    token, started, failed = _running.set(name), perf_counter(), True
    if watcher:
        watcher.begin(name)
    try:
        yield
        failed = False
    finally:
        if seconds is not None:
            seconds[name] = seconds.get(name, 0.0) + perf_counter() - started
        if watcher:
            watcher.end(name, failed)
        _running.reset(token)


def timed(name: str) -> Callable[[Callable[Parameters, Outcome]], Callable[Parameters, Outcome]]:
    """Decorate a function whose calls are a stage."""

    def decorate(function: Callable[Parameters, Outcome]) -> Callable[Parameters, Outcome]:
        @wraps(function)
        def call(*args: Parameters.args, **kwargs: Parameters.kwargs) -> Outcome:
            with stage(name):
                return function(*args, **kwargs)

        return call

    return decorate

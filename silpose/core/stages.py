"""Seconds that a run spends on each of its stages."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import wraps
from time import perf_counter
from typing import ParamSpec, TypeVar

Parameters = ParamSpec("Parameters")
Outcome = TypeVar("Outcome")

_seconds: ContextVar[dict[str, float] | None] = ContextVar("seconds", default=None)
_running: ContextVar[str | None] = ContextVar("running", default=None)


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


@contextmanager
def stage(name: str) -> Iterator[None]:
    """Time what happens inside; a stage inside another one counts as part of that."""
    seconds = _seconds.get()
    if seconds is None or _running.get() is not None:
        yield
        return
    token, started = _running.set(name), perf_counter()
    try:
        yield
    finally:
        seconds[name] = seconds.get(name, 0.0) + perf_counter() - started
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

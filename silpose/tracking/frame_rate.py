"""Frame rates of what is tracked."""

from __future__ import annotations

from silpose.core.errors import InputError


def check_rate(trained: float, given: float | None) -> None:
    """Refuse a sequence of another frame rate than the training sequences'."""
    if given is not None and abs(given / trained - 1) > 0.02:
        raise InputError(
            f"this tracker was trained at {trained:g} frames per second and cannot follow "
            f"{given:g}: resample the sequence, or train at its rate"
        )

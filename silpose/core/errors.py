"""The exception whose message is meant for the user."""


class InputError(ValueError):
    """An input that cannot be used; the message names the culprit and a remedy."""

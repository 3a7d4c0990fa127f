"""The one exception whose message is meant for the person at the keyboard."""


class InputError(ValueError):
    """Something the user gave cannot be used; the message names the culprit and the remedy."""

"""Names of files that are not UTF-8, as older systems wrote them, in words that can be shown."""


def readable(text: str) -> str:
    """Put a question mark in the place of each byte that is part of no character.

    Python keeps such a byte of a file's name as half a character, which opens the file again but
    can be neither drawn nor written.

    Parameters
    ----------
    text : str

    Returns
    -------
    text : str
    """
    return text.encode(errors="replace").decode()

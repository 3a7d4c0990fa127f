"""Names of files that are not UTF-8, as older systems wrote them, in words that can be shown."""


def readable(text: str) -> str:
    r"""Write each byte that is part of no character as its number, such as ``\xfc``.

    Python keeps such a byte of a file's name as half a character, which opens the file again but
    can be neither drawn nor written. Different names stay different.

    Parameters
    ----------
    text : str

    Returns
    -------
    text : str
    """
    try:
        stored = text.encode(errors="surrogateescape")
    except UnicodeEncodeError:  # half a character that is no byte of a name
        stored = text.encode(errors="replace")
    return stored.decode(errors="backslashreplace")

"""Files that were damaged on their way, drawn by Hypothesis."""

from hypothesis import strategies as st

_JUNK = st.one_of(
    st.binary(max_size=9),
    st.sampled_from([bytes(64), b"\xff" * 8, b"\x80", b"9" * 30, b"-1", b"nan", b"1e999", b'{["']),
)


@st.composite
def damaged(draw, whole):
    """Bytes of a file with one to four pieces cut out, put in, repeated, or bits turned."""
    content = whole
    for _ in range(draw(st.integers(1, 4))):
        at = draw(st.integers(0, max(0, len(content) - 1)))
        kind = draw(st.sampled_from(["end", "cut", "put", "over", "again", "bit"]))
        length = draw(st.integers(1, 200))
        junk = draw(_JUNK) if kind in ("put", "over") else b""
        if kind == "end":
            content = content[:at]
        elif kind == "cut":
            content = content[:at] + content[at + length :]
        elif kind in ("put", "over"):
            content = content[:at] + junk + content[at + len(junk) * (kind == "over") :]
        elif kind == "again":
            content = content[: at + length] + content[at:]
        elif content:
            turned = bytes([content[at] ^ 1 << draw(st.integers(0, 7))])
            content = content[:at] + turned + content[at + 1 :]
    return content


_WORDS = [
    *("nan", "inf", "-1", "0", "1e30", "1e-30", "1e999", "1000000000", "x", '"', "'", "%"),
    *(
        "{",
        "}",
        "[",
        "]",
        ",",
        ":",
        "=",
        "/",
        "\x00",
        "\n",
        "\u2028",
        "é",
        "null",
        "true",
        "${seed}",
    ),
]


@st.composite
def reworded(draw, text):
    """A text with one to four words replaced, repeated, left out or put in."""
    words = text.split(" ")
    for _ in range(draw(st.integers(1, 4))):
        at = draw(st.integers(0, len(words) - 1))
        kind = draw(st.sampled_from(["other", "again", "out", "in", "one of its own"]))
        word = draw(st.sampled_from(_WORDS))
        if kind == "one of its own":
            word = draw(st.sampled_from(words))
        new = {"again": [words[at]] * 2, "out": [], "in": [words[at], word]}.get(kind, [word])
        words = words[:at] + new + words[at + 1 :] or [""]
    return " ".join(words)

from silpose.recording import palette
from silpose.recording.page_style import PAGE_HEAD, PAGE_STYLE


def test_pages_fit_phones_and_both_themes():
    assert "width=device-width" in PAGE_HEAD
    assert "prefers-color-scheme: dark" in PAGE_STYLE
    assert palette.hexed(palette.TRUE) in PAGE_STYLE

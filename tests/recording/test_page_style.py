from silpose.recording import palette
from silpose.recording.page_style import PAGE_HEAD, PAGE_STYLE


def test_pages_fit_phones_and_both_themes():
    assert "width=device-width" in PAGE_HEAD
    assert "prefers-color-scheme: dark" in PAGE_STYLE
    assert palette.hexed(palette.TRUE) in PAGE_STYLE


def test_rows_and_figures_are_printed_on_one_sheet():
    printed = PAGE_STYLE[PAGE_STYLE.index("@media print") :]
    assert "tr, figure, svg { break-inside: avoid; }" in printed

"""How pages look that a browser shows: one style sheet for light and dark."""

from __future__ import annotations

from silpose.recording import palette

PAGE_HEAD = (
    '<meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">'
)
"""What the head of a page begins with; a phone then shows text at a size that can be read."""

PAGE_STYLE = f"""
:root {{ color-scheme: light dark; --ink: #222; --page: #fff; --dim: #666; --line: #ccc;
        --link: {palette.hexed(palette.TRUE)}; }}
@media (prefers-color-scheme: dark) {{
  :root {{ --ink: #ddd; --page: #16181c; --dim: #999; --line: #444;
          --link: {palette.hexed(palette.MODES[3])}; }}
}}
body {{ font: 15px system-ui, sans-serif; margin: 2em auto; max-width: 75em; padding: 0 1em;
       color: var(--ink); background: var(--page); }}
a {{ color: var(--link); }}
table {{ border-collapse: collapse; width: 100%; }}
th {{ font-weight: normal; color: var(--dim); }}
th, td {{ text-align: right; padding: .3em .6em; font-variant-numeric: tabular-nums; }}
td {{ border-top: 1px solid var(--line); }}
.dim {{ color: var(--dim); }}
@media print {{ body {{ margin: 0; }}
  tr, figure, svg {{ break-inside: avoid; }} h1, h2, h2 + p, th {{ break-after: avoid; }} }}
"""

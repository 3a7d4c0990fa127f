"""Execute the notebooks and render them as pages, with a gallery of them.

    python docs/notebooks.py            # all, into docs/gallery/
    python docs/notebooks.py 01 04      # those whose names begin so

Pages need nothing but themselves; each viewer is a picture in them.
"""

from __future__ import annotations

import base64
import io
import sys
import tempfile
from collections.abc import Iterator, Sequence
from html import escape
from pathlib import Path
from typing import Any

import jupytext
from nbclient import NotebookClient
from nbconvert import HTMLExporter
from nbformat import NotebookNode
from PIL import Image

DOCS = Path(__file__).parent
NOTEBOOKS, GALLERY = DOCS.parent / "notebooks", DOCS / "gallery"
SHOWN = ("text/html", "text/markdown", "image/png", "text/plain")  # the first of an output
WIDGET = "application/vnd.jupyter.widget-view+json"
DARK = "static/theme-dark.css"  # of nbconvert's template
WIDTH = 640  # pixels of a thumbnail
STYLE = """
:root { color-scheme: light dark; }
body { font: 16px system-ui, sans-serif; margin: 2em auto; max-width: 75em; padding: 0 1em; }
main { display: grid; gap: 1.2em; grid-template-columns: repeat(auto-fill, minmax(18em, 1fr)); }
a { border: 1px solid #8884; border-radius: 6px; color: inherit; overflow: hidden;
    text-decoration: none; }
img { aspect-ratio: 16 / 9; background: #fff; display: block; object-fit: contain; width: 100%; }
h2 { font-size: 1.05em; margin: .8em 1em .4em; } p { margin: 0 1em 1em; }
"""


def executed(path: Path) -> NotebookNode:
    """Execute a notebook in a folder of its own."""
    notebook = jupytext.read(path)
    with tempfile.TemporaryDirectory() as folder:
        resources = {"metadata": {"path": folder}}
        NotebookClient(notebook, timeout=1800, resources=resources).execute()
    for cell in notebook.cells:  # viewers and progress bars, which a page cannot run
        if "outputs" in cell:
            cell.outputs = [each for each in cell.outputs if WIDGET not in each.get("data", {})]
    return notebook


def page(notebook: NotebookNode, title: str) -> str:
    """Render an executed notebook as HTML that fetches nothing, light or dark as the reader's."""
    exporter = HTMLExporter(
        embed_images=True, jquery_url="", mathjax_url="", mermaid_js_url="", require_js_url=""
    )
    exporter.config.NbConvertBase.display_data_priority = list(SHOWN)
    exporter.config.HTMLExporter.preprocessors = []
    text, _ = exporter.from_notebook_node(notebook, {"metadata": {"name": title}})
    dark = next(Path(each, DARK) for each in exporter.template_paths if Path(each, DARK).exists())
    style = f"@media (prefers-color-scheme: dark) {{ {dark.read_text(encoding='utf-8')} }}"
    return str(text).replace("</head>", f"<style>{style}</style></head>", 1)


def heading(notebook: NotebookNode) -> tuple[str, str]:
    """Title and first paragraph of a notebook."""
    title, text = notebook.cells[0].source.split("\n\n")[:2]
    return title.removeprefix("# "), text.replace("\n", " ")


def thumbnail(notebook: NotebookNode) -> Image.Image:
    """Last figure of a notebook, or where there is none the viewer's picture."""
    pictures = [data for data in _displayed(notebook) if "image/png" in data]
    figures = [data for data in pictures if "text/html" not in data]
    png = base64.b64decode((figures or pictures)[-1]["image/png"])
    image = Image.open(io.BytesIO(png)).convert("RGB")
    image.thumbnail((WIDTH, WIDTH))
    return image


def _displayed(notebook: NotebookNode) -> Iterator[dict[str, Any]]:
    for cell in notebook.cells:
        for output in cell.get("outputs", []):
            yield output.get("data", {})


def main(names: Sequence[str]) -> None:
    """Render the notebooks whose names begin with one of these, or all."""
    GALLERY.mkdir(exist_ok=True)
    cards = []
    for path in sorted(NOTEBOOKS.glob("*.py")):
        if names and not path.stem.startswith(tuple(names)):
            continue
        notebook = executed(path)
        title, text = heading(notebook)
        (GALLERY / f"{path.stem}.html").write_text(page(notebook, title), encoding="utf-8")
        thumbnail(notebook).save(GALLERY / f"{path.stem}.png")
        cards.append(
            f'<a href="{path.stem}.html"><img src="{path.stem}.png" alt="">'
            f"<h2>{escape(title)}</h2><p>{escape(text)}</p></a>"
        )
        print(f"{path.stem}: {GALLERY / path.stem}.html", flush=True)
    (GALLERY / "index.html").write_text(
        '<!doctype html><html lang="en"><meta charset="utf-8"><title>silpose: notebooks</title>'
        f'<meta name="viewport" content="width=device-width"><style>{STYLE}</style>'
        f"<h1>Notebooks</h1><main>{''.join(cards)}</main></html>\n",
        encoding="utf-8",
    )


if __name__ == "__main__":
    main(sys.argv[1:])

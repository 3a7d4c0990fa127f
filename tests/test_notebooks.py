from pathlib import Path

import jupytext
import nbclient
import pytest

NOTEBOOKS = sorted((Path(__file__).parents[1] / "notebooks").glob("*.py"))


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_runs_from_top_to_bottom(path, tmp_path, monkeypatch):
    monkeypatch.setenv("SILPOSE_FAST", "1")
    notebook = jupytext.read(path)
    client = nbclient.NotebookClient(
        notebook, timeout=300, resources={"metadata": {"path": tmp_path}}
    )
    client.execute()
    last = [cell for cell in notebook.cells if cell.cell_type == "code"][-1]
    shown = {kind for output in last.outputs for kind in output.get("data", {})}
    assert shown & {"application/vnd.jupyter.widget-view+json", "image/png"}


def test_the_first_look_takes_five_cells():
    notebook = jupytext.read(next(path for path in NOTEBOOKS if path.stem == "01_first_look"))
    assert sum(cell.cell_type == "code" for cell in notebook.cells) == 5

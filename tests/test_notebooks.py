import os
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path

import jupytext
import nbclient
import pytest
from browser import chromium, evaluate, listening, opened, picture, wait_for

from silpose.recording.viewer.process import free_port

NOTEBOOKS = sorted((Path(__file__).parents[1] / "notebooks").glob("*.py"))


@pytest.mark.slow
@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_runs_from_top_to_bottom(path, tmp_path, monkeypatch):
    monkeypatch.setenv("SILPOSE_FAST", "1")
    monkeypatch.setenv(
        "OMP_NUM_THREADS", "1"
    )  # there is little to compute: threads would only wait
    # Without a browser, the viewer need not be served, which takes time to pack its 30 MB.
    monkeypatch.setenv("RERUN_NOTEBOOK_ASSET", "http://127.0.0.1:9/widget.js")
    notebook = jupytext.read(path)
    client = nbclient.NotebookClient(
        notebook, timeout=300, resources={"metadata": {"path": tmp_path}}
    )
    client.execute()
    last = [cell for cell in notebook.cells if cell.cell_type == "code"][-1]
    shown = {kind for output in last.outputs for kind in output.get("data", {})}
    assert "application/vnd.jupyter.widget-view+json" in shown  # the embedded viewer


def test_the_first_notebook_has_five_cells():
    notebook = jupytext.read(next(path for path in NOTEBOOKS if path.stem == "01_first_look"))
    assert sum(cell.cell_type == "code" for cell in notebook.cells) == 5


@pytest.mark.slow
def test_a_viewer_is_drawn_in_jupyterlab(tmp_path):
    chromium()  # skips without one
    path = next(path for path in NOTEBOOKS if path.stem == "02_descriptor")
    jupytext.write(jupytext.read(path), tmp_path / "notebook.ipynb")
    with lab(tmp_path) as address, opened(address, tmp_path) as call:
        wait_for(lambda: evaluate(call, f"{KERNEL}.status == 'idle'"))
        evaluate(call, "void jupyterapp.commands.execute('notebook:run-all-cells')")

        def viewer_is_drawn():
            if (box := evaluate(call, VIEWER)) is None:
                return False
            left, top, right, bottom = (max(0, round(edge)) for edge in box)
            viewer = picture(call)[top:bottom, left:right].astype(int)
            coloured = viewer.max(axis=-1) - viewer.min(axis=-1) > 60 if viewer.size else viewer
            return coloured.sum() > 5000  # the viewer's own panels are grey

        wait_for(viewer_is_drawn, 180)


KERNEL = "jupyterapp.shell.currentWidget.sessionContext.session.kernel"
VIEWER = """
    (() => {
        const canvas = document.querySelector('.jp-OutputArea-output canvas');
        canvas.scrollIntoView();
        const box = canvas.getBoundingClientRect();
        return [box.left, box.top, box.right, box.bottom];
    })()
"""


@contextmanager
def lab(folder):
    """Start JupyterLab in a folder; yield the address of its ``notebook.ipynb``."""
    port = free_port()
    options = {
        "ServerApp.ip": "127.0.0.1",
        "ServerApp.port": port,
        "ServerApp.port_retries": 0,
        "ServerApp.allow_root": True,
        "ServerApp.root_dir": folder,
        "IdentityProvider.token": "test",
        "LabApp.expose_app_in_browser": True,
    }
    places = ("CONFIG_DIR", "DATA_DIR", "RUNTIME_DIR")
    own = {f"JUPYTER_{place}": str(folder / "jupyter") for place in places}
    process = subprocess.Popen(
        [sys.executable, "-m", "jupyterlab", "--no-browser"]
        + [f"--{name}={value}" for name, value in options.items()],
        env=os.environ | own | {"SILPOSE_FAST": "1", "OMP_NUM_THREADS": "1"},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    try:
        wait_for(lambda: listening(port))
        yield f"http://127.0.0.1:{port}/lab/tree/notebook.ipynb?token=test"
    finally:
        process.terminate()
        process.wait()

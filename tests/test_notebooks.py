import os
import re
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path

import jupytext
import nbclient
import nbformat
import pytest
from browser import chromium, evaluate, listening, opened, picture, wait_for

from silpose.recording.viewer.process import free_port

NOTEBOOKS = sorted((Path(__file__).parents[1] / "notebooks").glob("*.py"))

SECONDS = {
    "04_tracking": 8,
    "06_compare_runs": 2,
    "08_fitting": 3,
    "09_video": 3,
}  # of each take, else 4
SHORT = """
import silpose.motion
short = {{"seconds": {seconds}, "test_seconds": {seconds}}}
def short_takes(takes=silpose.motion.WalkerTakes, **given):
    return takes(**given | short)
def short_run(settings, run=silpose.run_experiment):
    walkers = not any(setting.startswith("motion=") for setting in settings)
    more = {small_model} if "experiment=video" in settings else []
    return run([*settings, *more, *(f"motion.{{k}}={{v}}" for k, v in short.items() if walkers)])
silpose.motion.WalkerTakes, silpose.run_experiment = short_takes, short_run
"""
SMALL_MODEL = [
    "silhouette.scenes.frames=200",
    "silhouette.degradation.train=[none]",
    "silhouette.camera.width=96",
    "silhouette.camera.height=96",
    "descriptor.codebook_size=40",
    "fitting.starts=1",
    "fitting.iterations=6",
    "cache=models",
]
LARGE, SMALL = "(640, 352), 30", "(320, 176), 15"  # size and rate of the film that is rendered


def short_notebook(path):
    """Read a notebook, and let it run on takes of a few seconds, films in small pictures."""
    notebook = jupytext.read(path)
    for cell in notebook.cells:
        cell.source = cell.source.replace(LARGE, SMALL)
    code = SHORT.format(seconds=SECONDS.get(path.stem, 4), small_model=SMALL_MODEL)
    notebook.cells.insert(0, nbformat.v4.new_code_cell(code))
    return notebook


@pytest.mark.slow
@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_runs_from_top_to_bottom(path, tmp_path, monkeypatch):
    monkeypatch.setenv(
        "OMP_NUM_THREADS", "1"
    )  # there is little to compute: threads would only wait
    # Without a browser, the viewer need not be served, which takes time to pack its 30 MB.
    monkeypatch.setenv("RERUN_NOTEBOOK_ASSET", "http://127.0.0.1:9/widget.js")
    notebook = short_notebook(path)
    client = nbclient.NotebookClient(
        notebook, timeout=300, resources={"metadata": {"path": tmp_path}}
    )
    client.execute()
    last = [cell for cell in notebook.cells if cell.cell_type == "code"][-1]
    shown = {kind for output in last.outputs for kind in output.get("data", {})}
    assert "application/vnd.jupyter.widget-view+json" in shown  # the embedded viewer
    assert "image/png" in shown  # what a page made of the notebook shows
    if path.stem == "04_tracking":
        words = "".join(each.text for cell in notebook.cells[2:] for each in printed(cell))
        error = dict(re.findall(r"^(\w+): ([\d.]+)°$", words, flags=re.MULTILINE))
        assert float(error["tracker_lag"]) < float(error["ridge"])  # as its title says


def printed(cell):
    """Outputs of a cell that are text alone."""
    return [output for output in cell.get("outputs", []) if output.output_type == "stream"]


def test_the_first_notebook_has_five_cells():
    notebook = jupytext.read(next(path for path in NOTEBOOKS if path.stem == "01_first_look"))
    assert sum(cell.cell_type == "code" for cell in notebook.cells) == 5


@pytest.mark.slow
def test_a_viewer_is_drawn_in_jupyterlab(tmp_path):
    chromium()  # skips without one
    path = next(path for path in NOTEBOOKS if path.stem == "02_descriptor")
    jupytext.write(short_notebook(path), tmp_path / "notebook.ipynb")
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
        env=os.environ | own | {"OMP_NUM_THREADS": "1"},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    try:
        wait_for(lambda: listening(port))
        yield f"http://127.0.0.1:{port}/lab/tree/notebook.ipynb?token=test"
    finally:
        process.terminate()
        process.wait()

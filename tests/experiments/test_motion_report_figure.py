from dataclasses import replace

import numpy as np
import pytest

from silpose.experiments.motion_report_figure import motion_figure
from silpose.motion import MotionFolder, WalkerTakes, save_bvh


@pytest.fixture(scope="module")
def takes(tmp_path_factory):
    folder = tmp_path_factory.mktemp("walk")
    for k, take in enumerate(WalkerTakes(seconds=3, test_seconds=3).takes()[:2]):
        save_bvh(folder / f"{k}.bvh", take)
    read = MotionFolder(folder)
    return {file.name: read.captured(file) for file in read.files()}


def test_each_take_has_a_row_of_three_views(takes):
    figure = motion_figure(takes)
    assert len(figure.axes) == 6
    titles = [axes.get_title("left") for axes in figure.axes[:3]]
    assert titles[0].startswith("0.bvh") and "front" in titles[0]
    assert titles[1:] == ["from the right", "path of the hips, from above"]


def test_the_skeleton_lies_over_the_files_own_joints(takes):
    """Both have the same bones here, as the file has the project's skeleton."""
    axes = motion_figure(takes).axes[0]
    theirs = np.concatenate([line.get_xydata() for line in axes.lines if line.get_lw() == 4])
    ours = np.concatenate([line.get_xydata() for line in axes.lines if line.get_lw() == 1.5])
    nearest = np.linalg.norm(ours[:, None] - theirs[None], axis=-1).min(axis=1)
    assert np.quantile(nearest, 0.8) < 0.02


def test_a_take_of_one_frame_is_drawn(takes):
    (name, take), *_ = takes.items()
    single = replace(
        take,
        angles=take.angles[:1],
        root_position=take.root_position[:1],
        source=take.source[:1],
    )
    assert len(motion_figure({name: single}).axes) == 3

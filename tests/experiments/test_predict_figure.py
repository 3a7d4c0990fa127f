from dataclasses import replace

import numpy as np
import pytest

from silpose.experiments.predict_figure import prediction_figure


@pytest.mark.parametrize("frames", [1, 3, 12])
def test_masks_are_drawn_with_skeletons_and_doubt(finished, mask_folder, frames):
    details = finished.model.explain(mask_folder, blank="nan")
    poses = finished.model.predict(details)
    few = np.arange(12) < frames
    poses = replace(
        poses,
        x=poses.x[few],
        confidence=np.full(frames, 0.3),
        state=poses.state[:frames],
        time=poses.time[few],
        facts=poses.facts[few],
    )
    figure = prediction_figure(details, poses)
    drawn = [axes for axes in figure.axes if axes.images]
    assert len(drawn) == frames
    assert [bool(axes.lines) for axes in drawn] == [frame != 5 for frame in range(frames)]
    words = [axes.get_xlabel().partition(",")[0] for axes in drawn]
    assert [own == "blank" for own in words] == [frame == 5 for frame in range(frames)]
    shaded = [axes for axes in figure.axes if axes.patches]
    assert len(shaded) == (2 if frames > 5 else 0)
    assert "doubtful" in figure.get_suptitle()
    figure.canvas.draw()

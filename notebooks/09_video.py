# ---
# jupyter:
#   jupytext:
#     text_representation:
#       extension: .py
#       format_name: percent
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [markdown]
# # From a film to a moving skeleton
#
# A camera that stands still, and one person who walks by. **1. The film.** Put your own into the
# first line; without one, a walker is rendered before a wall.

# %%
import cv2
import numpy as np

film = None  # such as "walk.mp4"

if film is None:
    from silpose.dataset import render_take
    from silpose.motion import Straight, WalkerModel
    from silpose.silhouette import Body, Camera

    film, size, rate = "rendered.mp4", (640, 352), 30
    rng = np.random.default_rng(3)
    walk = WalkerModel.load().sample(rng, 0.5).walk(Straight(90.0), 4.2, rate, rng)
    camera = Camera(focal_length=1.4, elevation=3, width=size[0], height=size[1], follow=False)
    masks = render_take(walk, Body(), camera).masks
    bricks = rng.uniform(70, 190, (12, 20, 3)).astype(np.float32)
    wall = cv2.GaussianBlur(cv2.resize(bricks, size, interpolation=cv2.INTER_CUBIC), (0, 0), 5)
    video = cv2.VideoWriter(film, cv2.VideoWriter.fourcc(*"mp4v"), rate, size)
    for mask in [0 * masks[0], *masks, 0 * masks[0]]:
        clothes = np.where(np.arange(size[1])[:, None, None] < 0.56 * size[1], (60, 40, 150), 45)
        picture = np.where(mask[..., None] > 0, clothes, wall) + rng.normal(0, 2, (*size[::-1], 3))
        video.write(picture.clip(0, 255).astype(np.uint8))
    video.release()

# %% [markdown]
# **2. The person.** The background is the median of the clip; what differs from it, in more than
# brightness, is the person.

# %%
import matplotlib.pyplot as plt

from silpose.recording.figure_style import STYLE
from silpose.silhouette.video import VideoMasks

plt.style.use(STYLE)
frames = list(VideoMasks(film))
_, row = plt.subplots(1, 4, figsize=(12, 2))
for axes, k in zip(row, np.linspace(5, len(frames) - 6, 4).astype(int), strict=True):
    axes.imshow(frames[k].picture)
    axes.contour(frames[k].mask, [0.5], colors="C2")
    axes.set_title(f"{frames[k].time:.1f} s: {frames[k].state}", fontsize=9)
    axes.axis("off")
plt.show()

# %% [markdown]
# **3. Poses and gait.** A model is trained once for all films, in about three minutes, and kept.
# The body is fitted to all masks together. The same in the terminal: `silpose video FILE`, and live
# from a camera `silpose video 0 silhouette=video_mog2 recording=viewer`, which keeps no picture.

# %%
import silpose

run = silpose.run_experiment(
    ["experiment=video", f"silhouette.source={film}", "recording.name=notebook"]
)
print(run.summary)

# %%
import pandas

from silpose.recording import palette

gait = pandas.read_csv(run.folder / "gait.csv")
both = gait.loc[gait["side"] == "both", ["name", "value", "unit", "strides", "reason"]]
print(both.fillna({"reason": ""}).to_string(index=False, na_rep="-"))
angles = gait[gait["percent"].notna()]
for side, own in angles[angles["name"] == "knee_flexion"].groupby("side"):
    colour = palette.hexed(palette.shade(palette.ESTIMATED, side))
    plt.plot(own["percent"], own["value"], color=colour, label=f"{side} knee")
plt.xlabel("gait cycle, %")
plt.ylabel("flexion, degrees")
plt.legend(loc="lower right", bbox_to_anchor=(1, 1), ncols=2)
plt.show()

# %% [markdown]
# **4. Watch it.** The picture with the mask, the outline of the fitted body and its skeleton; the
# pose on its path; hip and knee below. `track.csv`, `track.bvh` and `track.trc` lie beside it.

# %%
silpose.show(run.recording)

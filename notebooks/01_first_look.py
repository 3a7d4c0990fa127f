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
# # From nothing to a pose
#
# A camera sees only someone's silhouette. What is the pose behind it?
#
# *In JupyterLab, open this file by right-click, Open With, Notebook.*
#
# **1. People walk before a camera.** Ten walkers are drawn from a statistical model of walking and
# photographed as masks: eight to learn from, one to choose settings by, one to be tested on.

# %%
import os

from silpose.app.config import build_components, load

fast = ["motion.seconds=4", "motion.test_seconds=4"] if os.environ.get("SILPOSE_FAST") else []
rooms = build_components(load(fast))
data = rooms.dataset()
test = data.test[0]

# %% [markdown]
# **2. What the camera sees** of the test walker, twice a second.

# %%
import matplotlib.pyplot as plt
import numpy as np

plt.figure(figsize=(12, 3))
plt.imshow(np.hstack(test.masks[:60:7, :, 60:-60]), cmap="gray_r")
plt.axis("off")
plt.show()

# %% [markdown]
# **3. Learn.** Each mask becomes a histogram of shape contexts; a relevance vector machine learns
# which training silhouettes are worth remembering, and to tell the pose from likeness to them.

# %%
from silpose.dataset import poses
from silpose.model.pose_model import PoseModel
from silpose.regression import Basis, RelevanceVectorRegressor

regressor = RelevanceVectorRegressor(Basis(width=2, hellinger=True), keep_at_most=0.18)
model = PoseModel(rooms.descriptor, regressor, data.space, test.frames_per_second)
model.fit(np.concatenate([take.masks for take in data.train]), poses(data.train))
print(f"{len(regressor.relevance_)} of {len(poses(data.train))} silhouettes are kept")

# %% [markdown]
# **4. Look at the test walker,** whom it has never seen: estimated poses on the true ones, the
# heading as the walker turns, and how far off it is on average, beside always answering the mean
# pose.

# %%
from pathlib import Path

from IPython.display import Image

from silpose.experiments.figures import single_image_figure

seen = model.explain(test.masks)
errors = {
    "rvm": data.space.distance(test.x, seen.x),
    "mean_pose": data.space.distance(test.x, poses(data.train).mean(axis=0)),
}
means = {method: error.mean() for method, error in errors.items()}
figure = Path("first_look.png")
single_image_figure(figure, data.space, rooms.camera, test, seen.x, means, "rvm")
Image(figure)

# %% [markdown]
# **5. Watch it,** frame by frame, in the Rerun viewer. Press play. *Why this pose?* says which
# training silhouettes speak for it.

# %%
from silpose.recording import Header, Reasons, Truth, record_single_image, show

truth = Truth.of(test, rooms.camera, errors, data.space)
why = Reasons.of(regressor, seen, data.train, rooms.camera, data.space)
header = Header("first_look", "notebook", Path("first_look.rrd"), f"test of {test.performer}")
record_single_image(header, model, seen, truth, list(errors), why)
show(header.file)

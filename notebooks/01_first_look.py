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

from silpose.config import furnish, load

fast = ["motion.seconds=4", "motion.test_seconds=4"] if os.environ.get("SILPOSE_FAST") else []
rooms = furnish(load(fast))
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
# %% [markdown]
# **3. Learn.** Each mask becomes a histogram of shape contexts; a relevance vector machine learns
# which training silhouettes are worth remembering, and to tell the pose from likeness to them.

# %%
from silpose.dataset import poses
from silpose.model import PoseModel
from silpose.regression import Basis, RelevanceVectorRegressor

regressor = RelevanceVectorRegressor(Basis(width=2, hellinger=True), keep_at_most=0.18)
model = PoseModel(rooms.descriptor, regressor, data.space, test.frames_per_second)
model.fit(np.concatenate([take.masks for take in data.train]), poses(data.train))
print(f"{len(regressor.relevance_)} of {len(poses(data.train))} silhouettes are kept")

# %% [markdown]
# **4. Look at the test walker,** and compare with the true poses, and with always answering the
# mean pose.

# %%
seen = model.look(test.masks)
errors = {
    "rvm": data.space.distance(test.x, seen.x),
    "mean_pose": data.space.distance(test.x, poses(data.train).mean(axis=0)),
}
for method, error in errors.items():
    print(f"{method}: {error.mean():.2f}° off on average over the 54 joint angles")

# %% [markdown]
# **5. Watch it,** frame by frame, in the Rerun viewer. Press play.

# %%
from silpose.recording import Reasons, Truth, record_single_image, show, texts

truth = Truth.of(test, rooms.camera, errors, data.space)
why = Reasons.of(regressor, seen, data.train, rooms.camera, data.space)
words = texts(f"test walker {test.performer}", "", {})
record_single_image("first_look.rrd", "first look", model, seen, truth, list(errors), words, why)
show("first_look.rrd")

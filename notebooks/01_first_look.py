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
# Of a person, only the silhouette is known. What is the pose?
#
# **1. Data.** Ten walkers are drawn from a statistical model of walking and rendered as masks:
# eight takes of training, one of validation and one of test.

# %%
from silpose.dataset import Renderer, SamePerformer
from silpose.motion import WalkerTakes

data = SamePerformer().load(Renderer(WalkerTakes()))
test = data.test[0]

# %% [markdown]
# **2. Masks** of the test walker, two in every second.

# %%
import matplotlib.pyplot as plt
import numpy as np

from silpose.recording.figure_style import STYLE

plt.style.use(STYLE)
plt.figure(figsize=(12, 3))
plt.imshow(np.hstack(test.masks[:60:7, :, 60:-60]), cmap="gray_r")
plt.box(False)
plt.yticks([])
plt.xticks(68 + 136 * np.arange(9), [f"{frame / 15:.1f}" for frame in range(0, 60, 7)])
plt.xlabel("seconds")
plt.show()

# %% [markdown]
# **3. Training.** Each mask becomes a histogram of shape contexts. A relevance vector machine keeps
# few of the training silhouettes, and regresses the pose on the similarity to them.

# %%
import silpose
from silpose.dataset import poses
from silpose.descriptor import ShapeContextHistogram
from silpose.regression import Basis, RelevanceVectorRegressor

regressor = RelevanceVectorRegressor(Basis(width=2), keep_at_most=0.18)
descriptor = ShapeContextHistogram()
model = silpose.PoseModel(descriptor, regressor, data.space, test.frames_per_second)
model.fit(np.concatenate([take.masks for take in data.train]), poses(data.train))
print(f"{len(regressor.relevance_)} of {len(poses(data.train))} silhouettes are kept")

# %% [markdown]
# **4. The test walker,** who is not in training: estimated poses on the true ones, the heading as
# the walker turns, and the mean error beside that of always estimating the mean pose.

# %%
from silpose.experiments.single_image_figure import single_image_figure

details = model.explain(test.masks)
errors = {
    "rvm": data.space.distance(test.x, details.x),
    "mean_pose": data.space.distance(test.x, poses(data.train).mean(axis=0)),
}
means = {method: error.mean() for method, error in errors.items()}
single_image_figure(data.space, test.camera, test, details.x, means, "rvm")

# %% [markdown]
# **5. Watch it,** frame by frame, in the Rerun viewer. Press play. *Why this pose?* shows the
# training silhouettes with the largest weight.

# %%
silpose.watch(model, test, data.train)

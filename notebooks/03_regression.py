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
# # How few examples are enough?
#
# A relevance vector machine keeps the training silhouettes that matter, one set for all 55 numbers
# of a pose. The larger ν, the fewer are kept.
#
# **1. Descriptors and poses** of ten walkers.

# %%
import numpy as np

from silpose.dataset import Renderer, SamePerformer, poses
from silpose.descriptor import ShapeContextHistogram
from silpose.motion import WalkerTakes

data = SamePerformer().load(Renderer(WalkerTakes()))
test = data.test[0]
descriptor = ShapeContextHistogram()
masks = np.concatenate([take.masks for take in data.train])
z, x = descriptor.fit_transform(masks), poses(data.train)
z_test, x_test = descriptor.transform(test.masks), test.x
print(z.shape, x.shape)

# %% [markdown]
# **2. A path over ν.** The regressors are scikit-learn estimators.

# %%
from silpose.regression import Basis, RelevanceVectorRegressor, RidgeRegressor

basis = Basis(width=2)
ridge = RidgeRegressor(basis, damping=0.1).fit(z, x)
path = [RelevanceVectorRegressor(basis, nu=nu).fit(z, x) for nu in (4, 8, 16, 32, 64, 128)]
errors = [data.space.distance(x_test, rvm.predict(z_test)).mean() for rvm in path]
for rvm, error in zip(path, errors, strict=True):
    print(f"nu={rvm.nu:3}: {rvm.kept_:4.0%} kept, error {error:.2f}°")

# %% [markdown]
# **3. Sparse against dense,** and against always estimating the mean pose.

# %%
import matplotlib.pyplot as plt

from silpose.recording.figure_style import STYLE

plt.style.use(STYLE)
dense = data.space.distance(x_test, ridge.predict(z_test)).mean()
mean_pose = data.space.distance(x_test, x.mean(axis=0)).mean()
plt.semilogx([rvm.kept_ for rvm in path], errors, "o-", color="C1", label="relevance vectors")
plt.axhline(dense, color="gray", ls="--", label="kernel ridge, all kept")
plt.axhline(mean_pose, color="gray", ls=":", label="mean pose")
plt.xlabel("share of the training silhouettes kept")
plt.ylabel("mean angular error, degrees")
plt.ylim(0)
plt.legend(loc="lower left", bbox_to_anchor=(0, 1), ncols=3)
plt.show()

# %% [markdown]
# **4. What is kept:** the training silhouettes whose coefficients are largest.

# %%
sparse = path[-2]
largest = np.argsort(-np.linalg.norm(sparse.coef_, axis=1))[:10]
kept = masks[sparse.basis_.indices_[largest]]
plt.figure(figsize=(12, 2.5))
plt.imshow(np.hstack(kept[:, :, 70:-70]), cmap="gray_r")
plt.axis("off")
plt.show()

# %% [markdown]
# **5. Uncertainty:** two standard deviations around the estimated left hip angle, and the true one.

# %%
from silpose.recording.figure_style import ESTIMATED, TRUE

estimated, std = sparse.predict(z_test, return_std=True)
column = data.space.columns.index("left_hip_x")
frames = np.arange(len(x_test))
low, high = (estimated[:, column] + k * std[:, column] for k in (-2, 2))
plt.figure(figsize=(12, 3))
plt.fill_between(
    frames, low, high, color=ESTIMATED, alpha=0.3, lw=0, label="two standard deviations"
)
plt.plot(frames, x_test[:, column], color=TRUE, label="true")
inside = np.mean((low < x_test[:, column]) & (x_test[:, column] < high))
plt.title(f"left hip: {inside:.0%} of the frames are inside")
plt.xlabel("frame")
plt.ylabel("left hip, degrees")
plt.xlim(0, len(frames) - 1)
plt.legend(loc="lower right", bbox_to_anchor=(1, 1), ncols=2)
plt.show()

# %% [markdown]
# **6. Watch it.** Vermilion bars show how much each kept silhouette contributes to the pose of a
# frame, and *Why this pose?* the ones with the largest weight.

# %%
import silpose

model = silpose.PoseModel(descriptor, sparse, data.space, test.frames_per_second)
silpose.watch(model, test, data.train)

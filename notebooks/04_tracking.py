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
# # One silhouette is ambiguous, a walk is not
#
# Which leg is in front? A single silhouette often does not determine it, but the ones before it do.
# The tracker propagates a belief over key poses from frame to frame.
#
# **1. Descriptors and poses,** take by take.

# %%
import numpy as np

from silpose.dataset import Renderer, SamePerformer, poses
from silpose.descriptor import ShapeContextHistogram
from silpose.motion import WalkerTakes

data = SamePerformer().load(Renderer(WalkerTakes()))
descriptor = ShapeContextHistogram()
descriptor.fit(np.concatenate([take.masks for take in data.train]))
train = [(descriptor.transform(take.masks), take.x) for take in data.train]
test = data.test[0]
z = descriptor.transform(test.masks)

# %% [markdown]
# **2. Estimates** of each image on its own, of the tracker, and of the tracker with a lag of half a
# second.

# %%
from silpose.regression import Basis, RidgeRegressor
from silpose.tracking import BeliefTracker

single = RidgeRegressor(Basis(width=2), damping=0.1)
single.fit(np.concatenate([z for z, _ in train]), poses(data.train))
tracker = BeliefTracker(pose_width=0.7, descriptor_width=0.8, damping=4.0).fit(train)
track = tracker.track(z, lag=7)
estimates = {
    "ridge": single.predict(z),
    "tracker": tracker.track(z).x,
    "tracker_lag": track.x,
}
for name, x in estimates.items():
    print(f"{name}: {data.space.distance(test.x, x).mean():.2f}°")

# %% [markdown]
# **3. The left thigh over time,** with glitches and without.

# %%
import matplotlib.pyplot as plt

from silpose.evaluation import thigh_swing
from silpose.recording.figure_style import ESTIMATED, STYLE, TRUE

plt.style.use(STYLE)
titles = {"ridge": "each image alone", "tracker": "tracked", "tracker_lag": "tracked, with a lag"}
_, rows = plt.subplots(3, figsize=(12, 6), sharex=True, sharey=True)
for axes, (name, x) in zip(rows, estimates.items(), strict=True):
    axes.plot(thigh_swing(data.space, test.x), color=TRUE, lw=3, alpha=0.7, label="true")
    axes.plot(thigh_swing(data.space, x), color=ESTIMATED, label="estimated")
    axes.set_title(titles[name])
    axes.set(ylim=(-60, 60), yticks=(-45, 0, 45), ylabel="degrees")
rows[0].legend(loc="lower right", bbox_to_anchor=(1, 1), ncols=2)
rows[-1].set_xlabel("frame")
plt.show()

# %% [markdown]
# **4. The belief** over key poses, ordered by their heading: it moves as the walker turns.

# %%
facing = data.space.heading(tracker.examples_.headings)
order = np.argsort(facing)
plt.figure(figsize=(12, 4))
plt.imshow(np.sqrt(track.beliefs[:, order].T), aspect="auto", interpolation="nearest")
plt.colorbar(label="square root of the probability")
plt.xlabel("frame")
plt.ylabel("key poses, by heading")
plt.show()

# %% [markdown]
# **5. Recovery** after a second without any silhouette.

# %%
blank = z.copy()
blank[25:40] = np.nan
recovered = tracker.track(blank)
error = data.space.distance(test.x, recovered.x)
plt.figure(figsize=(12, 3))
plt.plot(error, color=ESTIMATED, label="error")
plt.axvspan(25, 40, color="0.9", label="no silhouette")
lost = np.array([state == "lost" for state in recovered.state])
plt.fill_between(
    np.arange(len(error)), 0, 0.08 * error.max(), where=lost, color="0.4", label="lost"
)
plt.ylabel("mean angular error, degrees")
plt.xlabel("frame")
plt.ylim(0)
plt.legend(loc="lower right", bbox_to_anchor=(1, 1), ncols=3)
plt.show()

# %% [markdown]
# **6. Watch it.** Estimates side by side, each on the true pose; the tracker's state is in the lane
# below.

# %%
import silpose

model = silpose.PoseModel(descriptor, single, data.space, test.frames_per_second, tracker)
silpose.watch(model, test)

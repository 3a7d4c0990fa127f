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
import os

import numpy as np

from silpose.dataset import Renderer, SamePerformer, poses
from silpose.descriptor import ShapeContextHistogram
from silpose.motion import WalkerTakes

fast = {"seconds": 4, "test_seconds": 4} if os.environ.get("SILPOSE_FAST") else {}
data = SamePerformer().load(Renderer(WalkerTakes(**fast)))
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

_, rows = plt.subplots(3, figsize=(12, 6), sharex=True, sharey=True)
for axes, (name, x) in zip(rows, estimates.items(), strict=True):
    axes.plot(thigh_swing(data.space, test.x), "k", lw=2)
    axes.plot(thigh_swing(data.space, x), color="tab:orange")
    axes.set_title(name, fontsize=10)
rows[-1].set_xlabel("frame")
plt.show()

# %% [markdown]
# **4. The belief** over key poses, ordered by their heading: it moves as the walker turns.

# %%
facing = data.space.heading(tracker.examples_.headings)
order = np.argsort(facing)
plt.figure(figsize=(12, 4))
plt.imshow(np.sqrt(track.beliefs[:, order].T), aspect="auto", cmap="magma")
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
plt.plot(error)
lost = np.array([state == "lost" for state in recovered.state])
plt.fill_between(np.arange(len(error)), 0, error.max(), where=lost, alpha=0.3, label="lost")
plt.ylabel("error, degrees")
plt.xlabel("frame")
plt.legend()
plt.show()

# %% [markdown]
# **6. Watch it.** Estimates side by side, each on the true pose; the tracker's state is in the lane
# below.

# %%
from pathlib import Path

import silpose
from silpose.recording import GroundTruth, Header, record_tracking

errors = {name: data.space.distance(test.x, x) for name, x in estimates.items()}
truth = GroundTruth.of(test, test.camera, errors, data.space)
shown = {name: estimates[name] for name in ("ridge", "tracker")}
header = Header("tracking", "notebook", Path("tracking.rrd"), f"test of {test.performer}")
record_tracking(header, test, truth, shown, track, facing, data.space)
silpose.show(header.file)

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
# Which leg is in front? A silhouette often cannot tell, but the one before it could. The tracker
# carries a belief over key poses from frame to frame.
#
# **1. Descriptors and poses,** take by take.

# %%
import os

import numpy as np

from silpose.app.config import build_components, load
from silpose.dataset import poses

fast = ["motion.seconds=4", "motion.test_seconds=4"] if os.environ.get("SILPOSE_FAST") else []
rooms = build_components(load(fast))
data = rooms.dataset()
rooms.descriptor.fit(np.concatenate([take.masks for take in data.train]))
train = [(rooms.descriptor.transform(take.masks), take.x) for take in data.train]
test = data.test[0]
z = rooms.descriptor.transform(test.masks)

# %% [markdown]
# **2. Each image on its own,** the tracker, and the tracker when it may wait for half a second.

# %%
from silpose.regression import Basis, RidgeRegressor
from silpose.tracking import BeliefTracker

single = RidgeRegressor(Basis(width=2, hellinger=True), damping=0.1)
single.fit(np.concatenate([z for z, _ in train]), poses(data.train))
tracker = BeliefTracker(pose_width=0.7, descriptor_width=0.8, damping=4.0).fit(train)
track = tracker.track(z, lag=7)
estimates = {
    "ridge": single.predict(z),
    "tracker": tracker.track(z).x,
    "tracker_lag": track.x,
}
for name, x in estimates.items():
    print(f"{name}: {data.space.distance(test.x, x).mean():.2f}° off")

# %% [markdown]
# **3. The left thigh over time:** glitches, and none.

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
# **4. The belief** over key poses, ordered by where they face: it wanders as the walker turns.

# %%
facing = data.space.heading(tracker.examples_.headings)
order = np.argsort(facing)
plt.figure(figsize=(12, 4))
plt.imshow(np.sqrt(track.beliefs[:, order].T), aspect="auto", cmap="magma")
plt.xlabel("frame")
plt.ylabel("key poses, by heading")
plt.show()

# %% [markdown]
# **5. Lost and found:** a second without any silhouette.

# %%
blind = z.copy()
blind[25:40] = np.nan
found = tracker.track(blind)
error = data.space.distance(test.x, found.x)
plt.figure(figsize=(12, 3))
plt.plot(error)
lost = np.array([state == "lost" for state in found.state])
plt.fill_between(np.arange(len(error)), 0, error.max(), where=lost, alpha=0.3, label="lost")
plt.ylabel("error, degrees")
plt.xlabel("frame")
plt.legend()
plt.show()

# %% [markdown]
# **6. Watch it.** Estimates side by side, each on the truth; the tracker's state in the lane
# below.

# %%
from pathlib import Path

from silpose.recording import Header, Truth, record_tracking, show

errors = {name: data.space.distance(test.x, x) for name, x in estimates.items()}
truth = Truth.of(test, rooms.camera, errors, data.space)
shown = {name: estimates[name] for name in ("ridge", "tracker")}
header = Header("tracking", "notebook", Path("tracking.rrd"), f"test of {test.performer}")
record_tracking(header, test, truth, shown, track, facing, data.space)
show(header.file)

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
# # One silhouette, several poses
#
# Which leg is in front? Does the person come or go? A silhouette cannot always tell. A mixture of
# regressors gives all explanations, each with its probability.
#
# **1. Descriptors and poses,** take by take.

# %%
import os

import matplotlib.pyplot as plt
import numpy as np

from silpose.config import furnish, load

fast = [
    *("motion.seconds=4", "motion.test_seconds=4"),
    *("regression.mixture.clusters=30", "regression.mixture.temperature=8"),
]
rooms = furnish(load(fast if os.environ.get("SILPOSE_FAST") else []))
data = rooms.dataset()
rooms.descriptor.fit(np.concatenate([take.masks for take in data.train]))
train, validation, ((z, x),) = (
    [(rooms.descriptor.transform(take.masks), take.x) for take in takes]
    for takes in (data.train, data.validation, data.test)
)
test, space = data.test[0], data.space

# %% [markdown]
# **2. A mixture of regressors,** each for silhouettes and poses of one kind; how many, and how sure
# they are, is chosen on the validation take.

# %%
from silpose.regression import choose_mixture

mixture, _ = choose_mixture(
    train, validation, rooms.candidates.mixture, space.units, space.distance
)
weights, modes, _ = mixture.predict_modes(z, 8)
print(f"{mixture.components_} regressors; modes of one frame: {np.round(weights[0], 2)}")

# %% [markdown]
# **3. Frames with several explanations:** those whose second mode is likeliest. Each mode is drawn as
# the camera sees it, left limbs orange and right ones blue, the fainter the less probable.

# %%
doubtful = []
for frame in np.argsort(-weights[:, 1]):
    if len(doubtful) < 4 and all(abs(frame - other) > 5 for other in doubtful):
        doubtful.append(frame)
colours = {"left": "tab:orange", "right": "tab:blue"}
_, rows = plt.subplots(len(doubtful), 4, figsize=(10, 3 * len(doubtful)))
for row, frame in zip(rows, doubtful, strict=True):
    row[0].imshow(test.masks[frame, 20:, 50:-50], cmap="gray_r")
    row[0].set_title(f"frame {frame}")
    for k, axes in enumerate(row[1:]):
        joints, weight = space.joints(modes[frame])[k], weights[frame, k]
        for start, end in space.bones:
            colour = colours.get(space.joint_names[end].split("_")[0], "gray")
            axes.plot(*joints[[start, end], :2].T, color=colour, lw=3, alpha=min(1, 0.2 + weight))
        axes.set(aspect="equal", title=f"{weight:.0%}, faces {space.heading(modes[frame, k]):.0f}°")
for axes in rows.flat:
    axes.axis("off")
plt.show()

# %% [markdown]
# **4. How probable are they,** over time? Two bands that are equally thick are two explanations.

# %%
plt.figure(figsize=(12, 3))
plt.stackplot(np.arange(len(z)), weights[:, :4].T, labels=[f"mode {k + 1}" for k in range(4)])
plt.margins(0)
plt.xlabel("frame")
plt.ylabel("probability")
plt.legend(loc="lower left", ncols=4)
plt.show()

# %% [markdown]
# **5. The best of k.** If somebody told which of the first k modes is right: how far off would it be?

# %%
from silpose.regression import Basis, RidgeRegressor

ridge = RidgeRegressor(Basis(width=2, hellinger=True), damping=0.1)
ridge.fit(*(np.concatenate(part) for part in zip(*train, strict=True)))
off = space.distance(x[:, None], modes)
ks = np.arange(1, 9)
plt.plot(ks, [off[:, :k].min(axis=1).mean() for k in ks], "o-", label="mixture: best of k modes")
plt.axhline(
    space.distance(x, ridge.predict(z)).mean(),
    color="gray",
    ls="--",
    label="kernel ridge: one answer, a compromise",
)
plt.xlabel("k")
plt.ylabel("mean angular error, degrees")
plt.ylim(0)
plt.legend()
plt.show()

# %% [markdown]
# **6. Watch it.** The brighter a skeleton, the more probable; the true one is blue. See how often the
# second mode is the right one.

# %%
from pathlib import Path

from silpose.recording import Header, Truth, record_modes, show

best = {f"best of {k}": off[:, :k].min(axis=1) for k in (1, 4)}
truth = Truth.of(test, rooms.camera, best, space)
header = Header("ambiguity", "notebook", Path("ambiguity.rrd"), f"walker {test.performer}")
record_modes(header, test, truth, weights[:, :4], modes[:, :4], space)
show(header.file)

# %% [markdown]
# **7. Which one is it?** One silhouette does not say. Those before it do: `04_tracking` carries its
# belief from frame to frame.

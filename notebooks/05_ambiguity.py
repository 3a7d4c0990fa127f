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

from silpose.app.config import build_components, load

fast = [
    *("motion.seconds=4", "motion.test_seconds=4"),
    *("regression.mixture.clusters=30", "regression.mixture.temperature=8"),
]
rooms = build_components(load(fast if os.environ.get("SILPOSE_FAST") else []))
data = rooms.dataset()
rooms.descriptor.fit(np.concatenate([take.masks for take in data.train]))
train, validation, ((z, x),) = (
    [(rooms.descriptor.transform(take.masks), take.x) for take in takes]
    for takes in (data.train, data.validation, data.test)
)
test, space = data.test[0], data.space

# %% [markdown]
# **2. A mixture of regressors,** each for silhouettes and poses of one kind; how many, and how
# sure they are, is chosen on the validation take.

# %%
from silpose.regression import choose_mixture

mixture, _ = choose_mixture(
    train, validation, rooms.candidates.mixture, space.units, space.distance
)
weights, modes, _ = mixture.predict_modes(z, 8)
print(f"{mixture.components_} regressors; the first frame's modes: {np.round(weights[0], 2)}")

# %% [markdown]
# **3. Frames with several explanations:** those whose second mode is likely, and far from the
# first. Drawn as the camera sees them, left limbs orange and right ones blue.

# %%
doubtful = []
for frame in np.argsort(-weights[:, 1] * space.distance(modes[:, 0], modes[:, 1])):
    if len(doubtful) < 4 and all(abs(frame - other) > 5 for other in doubtful):
        doubtful.append(frame)
colours = {"left": "tab:orange", "right": "tab:blue"}
_, rows = plt.subplots(len(doubtful), 4, figsize=(10, 3 * len(doubtful)))
for row, frame in zip(rows, doubtful, strict=True):
    row[0].imshow(test.masks[frame, 20:, 50:-50], cmap="gray_r")
    row[0].set_title(f"frame {frame}")
    drawn = space.joints([*modes[frame, :2], x[frame]])
    names = [f"{weight:.0%}" for weight in weights[frame, :2]]
    for axes, joints, name in zip(row[1:], drawn, [*names, "true pose"], strict=True):
        for bone in space.bones:
            side = space.joint_names[bone[1]].split("_")[0]
            axes.plot(*joints[list(bone), :2].T, color=colours.get(side, "gray"), lw=3)
        axes.set(aspect="equal", title=name)
for axes in rows.flat:
    axes.axis("off")
plt.show()

# %% [markdown]
# **4. How probable are they,** over time? Two bands that are equally thick are two explanations;
# what is missing to 1 is for anything else: nothing much like this silhouette trained.

# %%
plt.figure(figsize=(12, 3))
plt.stackplot(np.arange(len(z)), weights[:, :4].T, labels=[f"mode {k + 1}" for k in range(4)])
plt.margins(0)
plt.xlabel("frame")
plt.ylabel("probability")
plt.legend(loc="lower left", ncols=4)
plt.show()

# %% [markdown]
# **5. The best of k.** If somebody told which of the first k modes is right: how far off would it
# be?

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
# **6. Which one is it?** One silhouette does not say. Those before it do: a tracker carries several
# hypotheses on, and what comes next decides between them.

# %%
from silpose.tracking import MultipleHypothesisTracker

tracks = MultipleHypothesisTracker(mixture).fit(train).track(z)
tracked = space.distance(x, tracks.x)
print(f"most probable mode {off[:, 0].mean():.2f}° off, tracked {tracked.mean():.2f}°")

# %% [markdown]
# **7. Watch it.** Left what each silhouette says by itself, right what the tracker makes of it; the
# brighter a skeleton, the more probable. The true one is blue.

# %%
from pathlib import Path

from silpose.recording import Header, Truth, record_hypotheses, show

truth = Truth.of(test, rooms.camera, {"mixture_top1": off[:, 0], "hypotheses": tracked}, space)
header = Header("hypotheses", "notebook", Path("ambiguity.rrd"), f"test of {test.performer}")
record_hypotheses(header, test, truth, (weights[:, :4], modes[:, :4]), tracks, space)
show(header.file)

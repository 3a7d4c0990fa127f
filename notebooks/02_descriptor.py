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
# # A silhouette as a hundred numbers
#
# From the outline of a mask to its descriptor z, and why z survives local damage.
#
# **1. Masks** of walkers, and the descriptor fitted to them: it learns a codebook.

# %%
import os

import matplotlib.pyplot as plt
import numpy as np

from silpose.app.config import build_components, load

fast = ["motion.seconds=4", "motion.test_seconds=4"] if os.environ.get("SILPOSE_FAST") else []
rooms = build_components(load(fast))
data = rooms.dataset()
train = np.concatenate([take.masks for take in data.train])
test = data.test[0]
descriptor = rooms.descriptor.fit(train)
seen = descriptor.describe(test.masks)

# %% [markdown]
# **2. One shape context.** Where does the rest of the outline lie, seen from one of the 200 edge
# points? Rings grow with the distance, so that what is near is seen in detail: a log-polar
# histogram.

# %%
widest = test.masks.any(axis=1).sum(axis=1).argmax()  # where legs are apart
mask, one = test.masks[widest], seen[widest]
x, y = one.points[40]
sectors = (np.arange(descriptor.angular_bins + 1) - 0.5) * 2 * np.pi / descriptor.angular_bins
figure = plt.figure(figsize=(10, 4.5))
left = figure.add_subplot(1, 2, 1)
left.imshow(mask, cmap="gray_r", alpha=0.3)
left.plot(*one.points.T, "k.", ms=3)
for radius in one.rings:
    left.add_patch(plt.Circle((x, y), radius, fill=False, color="tab:red", lw=0.8))
for angle in sectors:
    reach = one.rings[[0, -1]]
    left.plot(x + reach * np.cos(angle), y + reach * np.sin(angle), color="tab:red", lw=0.8)
left.axis([x - 80, x + 80, y + 80, y - 80])
left.axis("off")
right = figure.add_subplot(1, 2, 2, projection="polar")
right.set_theta_direction(-1)  # as in the image, down is down
context = one.contexts[40].reshape(descriptor.radial_bins, -1)
right.pcolormesh(sectors, np.arange(len(context) + 1), context, cmap="Reds")
right.set(xticks=[], yticks=[], title="its shape context: 5 rings of 12 bins")
plt.show()

# %% [markdown]
# **3. The codebook.** A hundred typical contexts, found by k-means. Each has a colour, and each
# edge point the colour of the centre that it is nearest to: arms, legs and head have their own.

# %%
from silpose.recording import codebook_picture

colours = plt.cm.hsv(np.arange(len(descriptor.codebook_)) / len(descriptor.codebook_))
_, (left, right) = plt.subplots(1, 2, figsize=(10, 5))
left.imshow(codebook_picture(descriptor.codebook_, descriptor.angular_bins))
right.imshow(mask, cmap="gray_r", alpha=0.15)
right.scatter(*one.points.T, c=colours[one.nearest], s=14)
right.axis([60, 196, 245, 10])
for axes in (left, right):
    axes.axis("off")
plt.show()

# %% [markdown]
# **4. The histogram.** Each edge point votes for the centres near its context; the votes are z.

# %%
plt.figure(figsize=(12, 2.5))
plt.bar(range(len(one.z)), 100 * one.z, color=colours, width=1)
plt.ylabel("% of the votes")
plt.xlabel("centre of the codebook")
plt.show()

# %% [markdown]
# **5. Damage is local.** Cut off a limb: only edge points near the cut see another context (red).
# The votes of the limb are gone, those of the cut are new, and the other bins hardly change.

# %%
from silpose.silhouette import DEGRADATIONS, contour_damage, degrade

damaged = degrade(mask, "missing_limb", 1.0, np.random.default_rng(1))
two = descriptor.describe([damaged])[0]
apart = np.linalg.norm(two.points[:, None] - one.points, axis=2)
moved = np.linalg.norm(two.contexts - one.contexts[apart.argmin(axis=1)], axis=1)
_, (left, right) = plt.subplots(1, 2, figsize=(12, 3.5), width_ratios=[1, 3])
left.imshow(mask.astype(int) + damaged, cmap="gray_r", alpha=0.3)
left.scatter(*two.points.T, c=moved, cmap="coolwarm", s=10)
left.axis([60, 196, 245, 10])
left.axis("off")
right.bar(range(len(one.z)), 100 * (two.z - one.z), color=colours, width=1)
right.axhline(0, color="k", lw=0.8)
right.set(ylabel="change, % of the votes", xlabel="centre of the codebook")
right.set_title(f"{50 * np.abs(one.z - two.z).sum():.0f} % of the votes have moved")
plt.show()

# %% [markdown]
# **6. All kinds of damage.** Votes move about as far as the outline is damaged: nothing breaks.

# %%
for kind in DEGRADATIONS:
    harm, votes = [], []
    for frame, whole in enumerate(test.masks[::6]):
        worse = degrade(whole, kind, 0.5, np.random.default_rng(frame))
        harm.append(100 * contour_damage(whole, worse))
        votes.append(50 * np.abs(seen[6 * frame].z - descriptor.transform([worse])[0]).sum())
    plt.plot(np.mean(harm), np.mean(votes), "o", label=kind.replace("_", " "))
plt.axline((0, 0), slope=1, color="0.8", zorder=0)
plt.xlabel("% of the outline lost or false")
plt.ylabel("% of the votes moved")
plt.legend(fontsize=8)
plt.show()

# %% [markdown]
# **7. Alike in z, alike in pose?** Every two frames of the test walk, dark where they are alike.
# The same stripes, but z has more: dark where silhouettes are alike and poses are not.

# %%
z = np.stack([description.z for description in seen])
between = {
    "descriptors": np.linalg.norm(np.sqrt(z)[:, None] - np.sqrt(z), axis=2),
    "poses": data.space.pairwise(test.x, test.x),
}
_, columns = plt.subplots(1, 2, figsize=(10, 5))
for axes, (name, distances) in zip(columns, between.items(), strict=True):
    axes.imshow(distances, cmap="magma")
    axes.set(title=name, xlabel="frame")
plt.show()

# %% [markdown]
# **8. Watch it.** Middle: all contexts in the plane of their two principal components. Press play,
# and see where this silhouette's lie.

# %%
from pathlib import Path

from silpose.descriptor.context_space import ContextSpace
from silpose.recording import Header, record_context_space, show

cloud = np.concatenate([d.contexts for d in descriptor.describe(train[::50])])
space = ContextSpace.of(cloud, descriptor.codebook_, seen)
header = Header("descriptor", "notebook", Path("descriptor.rrd"), f"test of {test.performer}")
rate = test.frames_per_second
book = descriptor.codebook_, descriptor.angular_bins
record_context_space(header, test.masks, seen, space, *book, rate)
show(header.file)

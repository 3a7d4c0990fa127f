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
# From the boundary of a mask to its descriptor z, and why z changes little by local damage.
#
# **1. Masks** of walkers, and the descriptor fitted to them: it learns a codebook.

# %%
import matplotlib.pyplot as plt
import numpy as np

from silpose.dataset import Renderer, SamePerformer
from silpose.descriptor import ShapeContextHistogram
from silpose.motion import WalkerTakes
from silpose.recording.figure_style import STYLE

data = SamePerformer().load(Renderer(WalkerTakes()))
plt.style.use(STYLE)
train = np.concatenate([take.masks for take in data.train])
test = data.test[0]
descriptor = ShapeContextHistogram().fit(train)
described = descriptor.describe(test.masks)

# %% [markdown]
# **2. One shape context** is a log-polar histogram of the boundary around one of the 200 edge
# points. Rings grow with the distance, so that it has more detail near the point.

# %%
widest = test.masks.any(axis=1).sum(axis=1).argmax()  # where the legs are apart
mask, one = test.masks[widest], described[widest]
x, y = one.points[40]
sectors = (np.arange(descriptor.angular_bins + 1) - 0.5) * 2 * np.pi / descriptor.angular_bins
figure = plt.figure(figsize=(10, 4.5))
left = figure.add_subplot(1, 2, 1)
left.imshow(mask, cmap="gray_r", alpha=0.3)
left.plot(*one.points.T, "k.", ms=3)
for radius in one.rings:
    left.add_patch(plt.Circle((x, y), radius, fill=False, color="C1", lw=0.8))
for angle in sectors:
    reach = one.rings[[0, -1]]
    left.plot(x + reach * np.cos(angle), y + reach * np.sin(angle), color="C1", lw=0.8)
left.axis([x - 80, x + 80, y + 80, y - 80])
left.set_title("an edge point and its log-polar bins")
left.axis("off")
right = figure.add_subplot(1, 2, 2, projection="polar")
right.set_theta_direction(-1)  # as in the image, down is down
context = one.contexts[40].reshape(descriptor.radial_bins, -1)
right.pcolormesh(sectors, np.arange(len(context) + 1), context, cmap="Purples")
right.set(xticks=[], yticks=[], title="its shape context")
plt.show()

# %% [markdown]
# **3. The codebook.** A hundred typical contexts, found by k-means. Each has a colour, and each
# edge point the colour of its nearest centre: arms, legs and head have their own.

# %%
from silpose.recording import codebook_picture

colours = plt.cm.hsv(np.arange(len(descriptor.codebook_)) / len(descriptor.codebook_))
_, (left, right) = plt.subplots(1, 2, figsize=(10, 5))
left.imshow(codebook_picture(descriptor.codebook_, descriptor.angular_bins))
right.imshow(mask, cmap="gray_r", alpha=0.15)
right.scatter(*one.points.T, c=colours[one.nearest], s=14)
left.set_title("the centres, as log-polar histograms")
right.set_title("edge points, in the colours of their centres")
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
# **5. Damage is local.** Without a limb, only edge points near the cut have another context (dark).
# The votes of the limb are gone, those of the cut are new, and the other bins hardly change.

# %%
from silpose.silhouette import DEGRADATIONS, contour_damage, degrade

damaged = degrade(mask, "missing_limb", 1.0, np.random.default_rng(1))
two = descriptor.describe([damaged])[0]
apart = np.linalg.norm(two.points[:, None] - one.points, axis=2)
moved = np.linalg.norm(two.contexts - one.contexts[apart.argmin(axis=1)], axis=1)
_, (left, right) = plt.subplots(1, 2, figsize=(12, 3.5), width_ratios=[1, 3])
left.imshow(mask.astype(int) + damaged, cmap="gray_r", alpha=0.3)
left.scatter(*two.points.T, c=moved, cmap="magma_r", s=14)
left.set_title("where contexts change")
left.axis([60, 196, 245, 10])
left.axis("off")
right.bar(range(len(one.z)), 100 * (two.z - one.z), color=colours, width=1)
right.axhline(0, color="k", lw=0.8)
right.set(ylabel="change, % of the votes", xlabel="centre of the codebook")
right.set_title(f"{50 * np.abs(one.z - two.z).sum():.0f} % of the votes have moved")
plt.show()

# %% [markdown]
# **6. All kinds of damage.** The votes that move are about as many as the boundary is damaged.

# %%
markers = "o^sDvP*X<>p"
for kind, marker in zip(DEGRADATIONS, markers, strict=True):
    damage, votes = [], []
    for frame, mask in enumerate(test.masks[::6]):
        damaged = degrade(mask, kind, 0.5, np.random.default_rng(frame))
        damage.append(100 * contour_damage(mask, damaged))
        votes.append(50 * np.abs(described[6 * frame].z - descriptor.transform([damaged])[0]).sum())
    plt.plot(np.mean(damage), np.mean(votes), marker, ms=7, label=kind.replace("_", " "))
plt.axline((0, 0), slope=1, color="0.8", zorder=0)
plt.xlabel("% of the boundary lost or false")
plt.ylabel("% of the votes moved")
plt.legend(loc="center left", bbox_to_anchor=(1, 0.5))
plt.show()

# %% [markdown]
# **7. Similar in z, similar in pose?** All pairs of frames of the test walk, dark where they are
# similar. The stripes are the same, but z has more: silhouettes are similar where poses are not.

# %%
z = np.stack([description.z for description in described])
between = {
    "descriptors": np.linalg.norm(np.sqrt(z)[:, None] - np.sqrt(z), axis=2),
    "poses": data.space.pairwise(test.x, test.x),
}
_, columns = plt.subplots(1, 2, figsize=(10, 5))
for axes, (name, distances) in zip(columns, between.items(), strict=True):
    axes.imshow(distances, cmap="magma")
    axes.set(title=f"distances of {name}", xlabel="frame", ylabel="frame")
plt.show()

# %% [markdown]
# **8. Watch it.** Middle: all contexts in the plane of their first two principal components. Press
# play to see where this silhouette's are.

# %%
import silpose

silpose.watch(descriptor, test, data.train)

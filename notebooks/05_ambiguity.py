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
# Which leg is in front? Does the person come or go? A silhouette does not always determine it. A
# mixture of regressors gives all likely poses, each with its probability.
#
# **1. Descriptors and poses,** take by take.

# %%
import matplotlib.pyplot as plt
import numpy as np

from silpose.dataset import Renderer, SamePerformer
from silpose.descriptor import ShapeContextHistogram
from silpose.motion import WalkerTakes
from silpose.recording.figure_style import STYLE

data = SamePerformer().load(Renderer(WalkerTakes()))
plt.style.use(STYLE)
descriptor = ShapeContextHistogram().fit(np.concatenate([take.masks for take in data.train]))
train, validation, ((z, x),) = (
    [(descriptor.transform(take.masks), take.x) for take in takes]
    for takes in (data.train, data.validation, data.test)
)
test, space = data.test[0], data.space

# %% [markdown]
# **2. A mixture of regressors,** each for silhouettes and poses of one kind. Their number, and how
# far their probabilities are trusted, are chosen on the validation take.

# %%
from silpose.regression import Candidates, MixtureOfRegressors, choose_mixture

grid = {"clusters": [30, 60, 120], "temperature": [4, 8, 16]}
grid["calibration_exponent"] = [0.7, 1, 1.4, 2, 2.8]
chosen = choose_mixture(
    Candidates(MixtureOfRegressors(), grid),
    train,
    validation,
    units=space.units,
    distance=space.distance,
)
mixture = chosen.mixture
weights, modes, _ = mixture.predict_modes(z, 8)
print(f"{mixture.components_} regressors; the first frame's modes: {np.round(weights[0], 2)}")

# %% [markdown]
# **3. Ambiguous frames:** those whose second mode is likely, and far from the first. Poses are
# drawn from the camera's point of view, left limbs light and right ones dark.

# %%
from silpose.experiments.figures import draw_skeleton
from silpose.recording import palette

ambiguous = []
for frame in np.argsort(-weights[:, 1] * space.distance(modes[:, 0], modes[:, 1])):
    if len(ambiguous) < 4 and all(abs(frame - other) > 5 for other in ambiguous):
        ambiguous.append(frame)
colours = [*palette.MODES[:2], palette.TRUE]
_, rows = plt.subplots(len(ambiguous), 4, figsize=(10, 3 * len(ambiguous)))
for row, frame in zip(rows, ambiguous, strict=True):
    row[0].imshow(test.masks[frame, 20:, 50:-50], cmap="gray_r")
    row[0].set_title(f"frame {frame}")
    drawn = space.joints([*modes[frame, :2], x[frame]])
    names = [f"{weight:.0%}" for weight in weights[frame, :2]]
    named = zip(row[1:], drawn, [*names, "true pose"], colours, strict=True)
    for axes, joints, name, colour in named:
        draw_skeleton(axes, space, joints[:, :2], colour, 3)
        axes.set(aspect="equal", title=name)
for axes in rows.flat:
    axes.axis("off")
plt.show()

# %% [markdown]
# **4. Probabilities over time.** Where two bands are equally thick, there are two explanations. The
# remaining probability is that of other poses: it is high where training has no similar silhouette.

# %%
shades = [palette.hexed(colour) for colour in palette.MODES]
plt.figure(figsize=(12, 3))
plt.stackplot(
    np.arange(len(z)), weights[:, :4].T, labels=[f"mode {k + 1}" for k in range(4)], colors=shades
)
plt.margins(0)
plt.xlabel("frame")
plt.ylabel("probability")
plt.ylim(0, 1)
plt.legend(loc="lower right", bbox_to_anchor=(1, 1), ncols=4)
plt.show()

# %% [markdown]
# **5. The best of k:** the error if it were known which of the first k modes is right.

# %%
from silpose.regression import Basis, RidgeRegressor

ridge = RidgeRegressor(Basis(width=2), damping=0.1)
ridge.fit(*(np.concatenate(part) for part in zip(*train, strict=True)))
errors = space.distance(x[:, None], modes)
ks = np.arange(1, 9)
plt.plot(
    ks,
    [errors[:, :k].min(axis=1).mean() for k in ks],
    "o-",
    color="C1",
    label="mixture: best of k modes",
)
plt.axhline(
    space.distance(x, ridge.predict(z)).mean(),
    color="gray",
    ls="--",
    label="kernel ridge: one estimate, a compromise",
)
plt.xlabel("k")
plt.ylabel("mean angular error, degrees")
plt.ylim(0)
plt.legend(loc="lower left", bbox_to_anchor=(0, 1))
plt.show()

# %% [markdown]
# **6. Tracking.** A single silhouette does not determine which mode is right, but a sequence does:
# a particle filter propagates several hypotheses, and later frames decide between them.

# %%
from silpose.tracking import MultipleHypothesisTracker

tracker = MultipleHypothesisTracker(mixture).fit(train)
track = tracker.track(z)
tracked = space.distance(x, track.x)
print(f"error of the most probable mode {errors[:, 0].mean():.2f}°, tracked {tracked.mean():.2f}°")

# %% [markdown]
# **7. Watch it.** Left the modes of each silhouette by itself, right the tracker's; the less
# probable a skeleton, the thinner and greyer it is. The true pose is blue.

# %%
import silpose

model = silpose.PoseModel(descriptor, ridge, space, test.frames_per_second, tracker)
silpose.watch(model, test)

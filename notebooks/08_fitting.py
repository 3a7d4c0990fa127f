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
# # Fit the body to the silhouette
#
# Regression compares a silhouette with those of training, and estimates a pose between theirs. The
# mask itself says more: where its contour is. A body is posed so that its outline explains the
# contour; what the contour leaves open, such as the twist of a limb, the regression decides.
#
# **1. Walkers,** and kernel ridge regression. The test walker is in none of the training takes.

# %%
import numpy as np

from silpose.core.pose_space import ANGLES
from silpose.dataset import Renderer, SamePerformer
from silpose.descriptor import ShapeContextHistogram
from silpose.motion import WalkerTakes
from silpose.regression import Basis, RidgeRegressor

data = SamePerformer().load(Renderer(WalkerTakes(test_seconds=10)))
descriptor = ShapeContextHistogram()
descriptor.fit(np.concatenate([take.masks for take in data.train]))
train = [(descriptor.transform(take.masks), take.x) for take in data.train]
test = data.test[0]
z = descriptor.transform(test.masks)


def regress(takes):
    """Fit the regressor to some of the training takes."""
    regressor = RidgeRegressor(Basis(width=2), damping=0.1)
    return regressor.fit(*(np.concatenate(part) for part in zip(*takes, strict=True)))


estimated = regress(train).predict(z)
print(f"error of the regression {ANGLES.distance(test.x, estimated).mean():.2f}°")

# %% [markdown]
# **2. How the regression errs** on takes that it was not trained on: half of them at a time. The
# covariance of these errors is the prior, which holds the fit where the contour says nothing.

# %%
from silpose.fitting import BodyFitter, PosePrior
from silpose.silhouette import Body

odd, even = train[1::2], train[::2]
left_out = [(x, regress(even).predict(own)) for own, x in odd]
left_out += [(x, regress(odd).predict(own)) for own, x in even]
prior = PosePrior.from_errors(*zip(*left_out, strict=True), test.frames_per_second)
fitter = BodyFitter(Body(), test.camera, prior)

# %% [markdown]
# **3. One frame converges:** the one whose mask the regression's pose covers worst. Grey is where
# mask and body are, blue where only the mask is, vermilion where only the body is.

# %%
import matplotlib.pyplot as plt

from silpose.experiments.fitting_figure import draw_overlap
from silpose.fitting import overlap, trace_frame
from silpose.recording.figure_style import STYLE
from silpose.silhouette import render

plt.style.use(STYLE)
before = list(render(Body(), test.camera, ANGLES.rotations(estimated)))
worst = int(np.argmin([overlap(*pair) for pair in zip(test.masks, before, strict=True)]))
trace = trace_frame(fitter, test.masks[worst], estimated[worst])
error = ANGLES.distance(test.x[worst], trace.x)
_, row = plt.subplots(1, 6, figsize=(12, 3.4))
for axes, k in zip(row, (0, 1, 2, 3, 5, 10), strict=True):
    draw_overlap(axes, trace.mask, trace.silhouettes[k])
    axes.set(xlim=(60, 196), ylim=(250, 6))
    axes.set_title(f"iteration {k}: {error[k]:.1f}°", fontsize=9)
    axes.axis("off")
plt.show()

# %% [markdown]
# **4. The whole take.** Alone, a frame may stop where a limb lies the wrong way, as the arms above,
# and it tells left from right by chance; as a take, whose poses follow each other, it does not.
# Poses of similar training silhouettes are tried as further starts.

# %%
from silpose.model import PoseFitter
from silpose.recording.figure_style import ESTIMATED

joined = (np.concatenate(part) for part in zip(*train, strict=True))
whole = PoseFitter(fitter, *joined, starts=3)
fit = whole.fit(test.masks, z, estimated, frames_per_second=test.frames_per_second)
tracks = {"ridge": estimated, "fitted_take": fit.x}
plt.figure(figsize=(12, 3))
for name, x in tracks.items():
    error = ANGLES.distance(test.x, x)
    colour = ESTIMATED if name == "fitted_take" else "0.5"
    plt.plot(error, color=colour, label=f"{name.replace('_', ' ')}: {error.mean():.2f}°")
plt.xlabel("frame")
plt.ylabel("mean angular error, degrees")
plt.ylim(0)
plt.legend(loc="lower right", bbox_to_anchor=(1, 1), ncols=2)
plt.show()

# %% [markdown]
# **5. What an outline does not show** is how far a limb is turned about its own bone: there the fit
# is as good as the regression, and its covariance says so.

# %%
from silpose.evaluation import coverage_by_limb, joint_distances, twist_errors

for name, x in tracks.items():
    values = twist_errors(ANGLES, test.x, x)
    joints = joint_distances(ANGLES, test.x, x).mean()
    print(
        f"{name:11}: twists {values['twist_error_deg']:.1f}°, "
        f"other angles {values['other_angles_error_deg']:.1f}°, joints {joints:.0f} mm"
    )
for row in coverage_by_limb(test.x, fit.x, fit.covariance)[:3]:
    print(f"{row['metric'].split('_')[1]:6}: 90 % intervals hold the truth in {row['value']:.0%}")

# %% [markdown]
# **6. Watch it.** In the viewer's first tab the take; in the second one the frame above, on the
# timeline *iteration*, which is chosen at the bottom left.

# %%
import silpose

regressor = regress(train)
model = silpose.PoseModel(descriptor, regressor, ANGLES, test.frames_per_second, fitter=whole)
silpose.watch(model, test)

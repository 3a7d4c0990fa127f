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
# # Your own motion, your own masks
#
# From a folder of BVH files and a video of masks to poses. Replace two paths by your own.
#
# **1. The paths.** `motion` is a folder of motion capture, `masks` a video of masks or a folder of
# mask images. If they do not exist, this cell makes an example: nine walkers as BVH, and the tenth,
# who is unseen in training, as a video. Delete the second half if the paths are your own.

# %%
from pathlib import Path

import cv2

from silpose.dataset import render_take
from silpose.motion import WalkerTakes, save_bvh
from silpose.silhouette import Body, Camera

motion, masks = Path("my_motion"), Path("my_masks.mp4")

if not motion.exists():
    motion.mkdir()
    *walks, unseen = WalkerTakes().takes()
    for walk in walks:
        save_bvh(motion / f"{walk.name}.bvh", walk)
    codec = cv2.VideoWriter.fourcc(*"mp4v")
    video = cv2.VideoWriter(str(masks), codec, 15, (256, 256), isColor=False)
    for mask in render_take(unseen, Body(), Camera()).masks:
        video.write(255 * mask)
    video.release()

# %% [markdown]
# **2. Is the motion read correctly?** Every file is put on the project's skeleton. People must
# stand upright, and walk where they did.
#
# *What may go wrong:* joints are found by name; a file whose joints have other names is left out
# with a warning that names the missing joint. Add its name by `joints={"left_elbow": ["MyElbowL"]}`
# here, and by `'motion.joints={left_elbow: [MyElbowL]}'` in 3. Files of any frame rate are
# resampled to 15 frames per second; +Y is up.

# %%
import matplotlib.pyplot as plt

from silpose.core.pose_space import ANGLES
from silpose.motion import MotionFolder
from silpose.recording.figure_style import ESTIMATED, STYLE

plt.style.use(STYLE)
takes = MotionFolder(motion).takes()
_, (above, front) = plt.subplots(1, 2, figsize=(12, 4), width_ratios=[1, 1.6])
for k, take in enumerate(takes):
    above.plot(*take.root_position[:, [0, 2]].T, color=f"C{k}")
    joints = ANGLES.joints(ANGLES.from_angles(take.angles[:1]))[0]
    for bone in ANGLES.bones:
        front.plot(*(joints[list(bone), :2] + [k, 0]).T, color=f"C{k}", lw=2)
    front.text(k, -1.2, take.name, rotation=60, ha="right", va="top", fontsize=8)
above.set(aspect="equal", title="paths from above", xlabel="metres", ylabel="metres")
above.invert_yaxis()  # z points down, to the camera
front.set(aspect="equal", title="first frame of each file")
front.axis("off")
plt.show()

# %% [markdown]
# **3. Train.** The last file is the test and the one before it the validation, unless you choose
# others (`'dataset.test=[…]'`). Cameras of training should be like yours:
# `silhouette.camera.elevation=5` degrees, `silhouette.camera.distance=4.5` metres, or many cameras
# and bodies by `silhouette/scenes=wide`.

# %%
import silpose

own = ["motion=bvh", f"motion.root={motion}", "methods=[rvm]"]
quick = ["regression.basis.width=2", "regression.rvm.nu=8"]  # without these, validation chooses
run = silpose.run_experiment([*own, *quick])
errors = {method: values["mean_angular_error_deg"] for method, values in run.metrics.items()}
print(f"error on the test file {errors['rvm']:.1f}°; of the mean pose {errors['mean_pose']:.1f}°")

# %% [markdown]
# **4. Are the masks correct?** One whole person, of any size and any usual encoding; `encoding`
# says how they were read.
#
# *What may go wrong:* limbs out of the frame, a floor or a shadow that is white as well. Of a film
# of a person, `silpose video` makes the masks itself (notebook 09); masks of any other segmentation
# are read as they are.

# %%
from silpose.silhouette import read_masks

images = read_masks(masks)
print(images.encoding)
print(
    f"{len(images)} masks of {images[0].shape} pixels, {images[0].mean():.0%} of the first is white"
)
_, row = plt.subplots(1, 8, figsize=(12, 2))
for axes, mask in zip(row, images[:: max(1, len(images) // 8)], strict=False):
    axes.imshow(mask, cmap="gray")
    axes.axis("off")
plt.show()

# %% [markdown]
# **5. Poses,** as numbers; `blank="nan"` gives a row of NaN where a mask is blank. Confidence
# is the probability that the pose is about right: below 0.5, do not trust it.

# %%
poses = run.model.predict(masks, blank="nan")
print(poses.summary())
print(f"joints in metres {poses.joints.shape}: {', '.join(poses.space.joint_names[:6])}, …")
_, (above, below) = plt.subplots(2, figsize=(12, 4), sharex=True)
above.plot(poses.heading, ".", color=ESTIMATED)
above.set(ylabel="heading, degrees", yticks=[-180, -90, 0, 90, 180])
below.plot(poses.confidence, color="0.3")
below.axhline(0.5, color="0.7", ls=":")
below.set(ylabel="confidence", xlabel="frame", ylim=(0, 1.05))
plt.show()

# %% [markdown]
# **6. For Blender,** as BVH, at the frame rate of the masks.

# %%
poses.save_bvh("my_poses.bvh", frames_per_second=15)

# %% [markdown]
# **7. Watch it.** In a terminal:
#
# ```sh
# silpose experiment=predict silhouette=masks silhouette.source=my_masks.mp4 \
#     model=recordings/single_image/001
# ```
#
# A model of `experiment=tracking` also tracks the person from frame to frame; it needs masks at the
# frame rate of its training: yours is set by `silhouette.frames_per_second=15`.

# %%
predict = ["experiment=predict", "silhouette=masks", "silhouette.blank=nan"]
predicted = silpose.run_experiment([*predict, f"silhouette.source={masks}", f"model={run.folder}"])
silpose.show(predicted.recording)

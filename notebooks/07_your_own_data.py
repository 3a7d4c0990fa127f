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
# From a folder of BVH files and a video of masks to poses. Replace two paths, and it is yours.
#
# **1. The paths.** `motion` is a folder of motion capture, `masks` a video of masks or a folder of
# mask images. If they do not exist, this cell makes an example: nine walkers as BVH, and a
# stranger, who does not train, as a video. Delete the second half when the paths are your own.

# %%
import os
from pathlib import Path

import cv2

from silpose.dataset import photograph
from silpose.motion import WalkerTakes, save_bvh
from silpose.silhouette import Body, Camera

motion, masks = Path("my_motion"), Path("my_masks.mp4")

if not motion.exists():
    motion.mkdir()
    seconds = 4 if os.environ.get("SILPOSE_FAST") else 17
    *walks, stranger = WalkerTakes(seconds=seconds, test_seconds=seconds).takes()
    for walk in walks:
        save_bvh(motion / f"{walk.name}.bvh", walk)
    codec = cv2.VideoWriter.fourcc(*"mp4v")
    video = cv2.VideoWriter(str(masks), codec, 15, (256, 256), isColor=False)
    for mask in photograph(stranger, Body(), Camera()).masks:
        video.write(255 * mask)
    video.release()

# %% [markdown]
# **2. Is the motion read as it should be?** Every file is put on the skeleton that is used here.
# Look for people who stand upright, and walk where they should.
#
# *What may go wrong:* joints are found by name; a file whose joints have other names is left out
# with a warning that says which joint is missing. Name it: `joints={"left_elbow": ["MyElbowL"]}`
# here, and `'motion.joints={left_elbow: [MyElbowL]}'` in 3. Files of any frame rate are brought to
# 15 frames a second; +Y is up.

# %%
import matplotlib.pyplot as plt

from silpose.core.pose_space import ANGLES
from silpose.motion import MotionFolder

takes = MotionFolder(motion).takes()
_, (above, front) = plt.subplots(1, 2, figsize=(12, 4), width_ratios=[1, 1.6])
for k, take in enumerate(takes):
    above.plot(*take.root_position[:, [0, 2]].T, color=f"C{k}")
    joints = ANGLES.joints(ANGLES.from_angles(take.angles[:1]))[0]
    for bone in ANGLES.bones:
        front.plot(*(joints[list(bone), :2] + [k, 0]).T, color=f"C{k}", lw=2)
    front.text(k, -1.2, take.name, rotation=60, ha="right", va="top", fontsize=8)
above.set(aspect="equal", title="from above, metres")
above.invert_yaxis()  # z points to the camera
front.set(aspect="equal", title="the first frame of each")
front.axis("off")
plt.show()

# %% [markdown]
# **3. Train.** The last file tests and the one before it validates, unless you name others
# (`'dataset.test=[…]'`). Training should see people as your camera does:
# `silhouette.camera.elevation=5` degrees, `silhouette.camera.distance=4.5` metres, or many cameras
# and bodies by `silhouette/scenes=wide`.

# %%
from silpose.app.config import load
from silpose.app.main import run_experiment

own = ["motion=bvh", f"motion.root={motion}", "methods=[rvm]"]
quick = ["regression.basis.width=2", "regression.rvm.nu=8"]  # without these, validation chooses
run = run_experiment(load([*own, *quick]))
errors = {method: values["mean_angular_error_deg"] for method, values in run.metrics.items()}
print(
    f"on an unseen file {errors['rvm']:.1f}° off; always the mean pose: {errors['mean_pose']:.1f}°"
)

# %% [markdown]
# **4. Are the masks as they should be?** One person, white on black, whole, of any size.
#
# *What may go wrong:* black on white (invert them), grey edges (they are cut at half of the
# brightest value), limbs out of the frame, a floor or a shadow that is white as well. silpose does
# not cut people out of pictures: any segmentation will do, or, before a camera that stands still,
# `cv2.createBackgroundSubtractorMOG2()`.

# %%
from silpose.silhouette import read_masks

seen = read_masks(masks, blank="nan")
print(f"{len(seen)} masks of {seen[0].shape} pixels, white: {seen[0].mean():.0%} of the first")
_, row = plt.subplots(1, 8, figsize=(12, 2))
for axes, mask in zip(row, seen[:: max(1, len(seen) // 8)], strict=False):
    axes.imshow(mask, cmap="gray")
    axes.axis("off")
plt.show()

# %% [markdown]
# **5. Poses,** as numbers; `blank="nan"` gives a row of NaN where nobody is seen. A heading norm
# far below 1 says that the silhouette could be of several poses, or is unlike all that trained.

# %%
poses = run.model.predict(masks, blank="nan")
print(f"joints in metres {poses.joints.shape}: {', '.join(poses.space.joint_names[:6])}, …")
_, (above, below) = plt.subplots(2, figsize=(12, 4), sharex=True)
above.plot(poses.heading, ".")
above.set(ylabel="heading, degrees", yticks=[-180, -90, 0, 90, 180])
below.plot(poses.heading_norm)
below.set(ylabel="heading norm", xlabel="frame", ylim=(0, 1.3))
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
# A model of `experiment=tracking` would follow the person from frame to frame; it wants masks at
# the frame rate that it was trained at: say yours by `silhouette.frames_per_second=15`.

# %%
from silpose.recording import show

predict = ["experiment=predict", "silhouette=masks", "silhouette.blank=nan"]
watched = run_experiment(load([*predict, f"silhouette.source={masks}", f"model={run.folder}"]))
show(watched.recording)

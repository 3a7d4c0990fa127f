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
# # Compare runs
#
# How large must the codebook be? A sweep as a table, as a plot, and two of its runs side by side.
#
# **1. A sweep.** In a terminal it is one command:
#
# ```sh
# silpose -m descriptor.codebook_size=5,10,25,100 'methods=[ridge]' show=ridge \
#     regression.basis.width=2 recording.root=sweep
# ```
#
# and here a loop. Each run has its own folder in `sweep/`.

# %%
import silpose

common = ["methods=[ridge]", "show=ridge", "regression.basis.width=2"]
sizes = [5, 10, 25, 100]
runs = []
for size in sizes:
    own = [f"descriptor.codebook_size={size}", "recording.root=sweep"]
    runs.append(silpose.run_experiment([*common, *own, f"recording.name=centres_{size}"]))

# %% [markdown]
# **2. The sweep as a table:** a row for each run, with the settings in which runs differ, and the
# values of all methods. `complete` is false for a run that was interrupted.

# %%
table = silpose.runs_table("sweep").sort_values("descriptor.codebook_size")
table[["descriptor.codebook_size", "ridge.mean_angular_error_deg", "ridge.mpjpe_mm"]].round(2)

# %% [markdown]
# **3. The error against the swept setting,** beside two baselines.

# %%
import matplotlib.pyplot as plt

from silpose.recording.figure_style import ESTIMATED, STYLE, TRUE

plt.style.use(STYLE)
error = "mean_angular_error_deg"
methods = {"ridge": ("o-", ESTIMATED), "nearest": ("s-", "C0"), "mean_pose": (":", "0.5")}
for method, (style, colour) in methods.items():
    values, label = table[f"{method}.{error}"], method.replace("_", " ")
    plt.semilogx(table["descriptor.codebook_size"], values, style, color=colour, label=label)
plt.xlabel("centres of the codebook")
plt.ylabel("mean angular error, degrees")
plt.xticks(sizes, sizes)
plt.minorticks_off()
plt.ylim(0)
plt.legend(loc="lower right", bbox_to_anchor=(1, 1), ncols=3)
plt.show()

# %% [markdown]
# **4. A run as data:** estimated and true poses of the test take, frame by frame.

# %%
small, large = silpose.load_run("sweep/single_image/centres_5"), runs[-1]
_, rows = plt.subplots(2, figsize=(12, 5), sharex=True, sharey=True)
for axes, run in zip(rows, (small, large), strict=True):
    tracks = run.tracks
    axes.plot(tracks.loc["true", "left_knee_x"], color=TRUE, lw=3, alpha=0.7, label="true")
    axes.plot(tracks.loc["estimated", "left_knee_x"], color=ESTIMATED, label="estimated")
    axes.set_ylabel("left knee, degrees")
    axes.set_title(f"{run.folder.name}: error {tracks.loc['estimated', 'error'].mean():.2f}°")
rows[0].legend(loc="lower right", bbox_to_anchor=(1, 1), ncols=2)
axes.set_xlabel("frame")
plt.show()

# %% [markdown]
# **5. Side by side on one timeline,** with both errors in one plot below. In a terminal: `silpose
# compare sweep/single_image/centres_5 sweep/single_image/centres_100`.

# %%
from pathlib import Path

from silpose.recording import compare

compare([small, large], Path("comparison.rrd"))
silpose.show("comparison.rrd")

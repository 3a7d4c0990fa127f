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
# # From nothing to a pose
#
# A person walks; a camera sees only the silhouette. What was the pose?
# Open this file in JupyterLab with *Open With → Notebook*.

# %%
import os

import silpose
from silpose.config import load, rooms

fast = ["motion.seconds=6", "motion.test_seconds=6"] if os.environ.get("SILPOSE_FAST") else []
settings = rooms(load(fast))

# %% [markdown]
# Ten walkers, drawn from a statistical model of walking, before a camera.

# %%
data = settings.dataset()
print(*(f"{s.name}: {len(s)} frames by {s.performer}" for s in data.train), sep="\n")

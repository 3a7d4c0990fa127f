"""Experiments: one file each, a short story that calls the rooms in order."""

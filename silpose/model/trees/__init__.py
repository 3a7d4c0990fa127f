"""Poses for trees of takes: a table per take and an index, on all cores, resumable."""

from silpose.model.trees.take_table import FORMATS, read_table
from silpose.model.trees.tree_prediction import TreeAnswer, predict_tree

__all__ = ["FORMATS", "TreeAnswer", "predict_tree", "read_table"]

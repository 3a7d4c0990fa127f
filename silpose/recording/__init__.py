"""Recordings: the only room that knows Rerun."""

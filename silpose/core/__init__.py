"""What all packages build on, and which itself knows none of them.

The skeleton, the meaning of a pose vector, and tools for errors, files, parameters, parallel work,
progress, serialisation and timing. Its modules are imported by name.
"""

__all__ = [
    "array_files",
    "atomic_files",
    "csv_text",
    "default_parts",
    "errors",
    "frame_border",
    "lazy_exports",
    "once",
    "parallel",
    "parameters",
    "pose_space",
    "progress",
    "random_states",
    "serialisation",
    "skeleton",
    "stage_lines",
    "stages",
    "types",
]

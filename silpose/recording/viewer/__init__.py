"""The Rerun viewer: its processes, live runs, screenshots, notebooks, and repair of recordings."""

from typing import TYPE_CHECKING

from silpose.core.lazy_exports import lazy_exports

if TYPE_CHECKING:
    from silpose.recording.viewer.notebook import show
    from silpose.recording.viewer.process import has_screen, open_recording, serving, wait
    from silpose.recording.viewer.salvage import repair
    from silpose.recording.viewer.screenshots import film, picture

# On first use: only screenshots and repair load Rerun.
__getattr__ = lazy_exports(
    __name__,
    {
        "notebook": ("show",),
        "process": ("has_screen", "open_recording", "serving", "wait"),
        "salvage": ("repair",),
        "screenshots": ("film", "picture"),
    },
)

__all__ = [
    "film",
    "has_screen",
    "open_recording",
    "picture",
    "repair",
    "serving",
    "show",
    "wait",
]

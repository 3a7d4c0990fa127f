"""From films to poses in metres: all frames fitted together or live, placed on the floor."""

from silpose.model.video.film_masks import FilmMasks
from silpose.model.video.film_poses import FilmPoses, fit_film
from silpose.model.video.live_track import LiveTrack
from silpose.model.video.live_video import live_steps
from silpose.model.video.placement import Placement, check_lengths
from silpose.model.video.track_files import track_files
from silpose.model.video.video_step import VideoStep
from silpose.model.video.video_track import VideoTrack

__all__ = [
    "FilmMasks",
    "FilmPoses",
    "LiveTrack",
    "Placement",
    "VideoStep",
    "VideoTrack",
    "check_lengths",
    "fit_film",
    "live_steps",
    "track_files",
]

r"""How well, and how fast, films become poses: python benchmarks/video.py [--fast] [ENVIRONMENT].

Films are those of ../shared/video where that is present, else one that is rendered here. From the
command line they are, with FILMS for ../shared/video:

    silpose video FILMS/walkgait/walk.mp4
    silpose video FILMS/balance/cam04.mp4 \
        silhouette.video.background=FILMS/balance/cam04_background.png

In ENVIRONMENT, a Python environment of its own, MediaPipe Pose goes over the same film.
"""

import subprocess
import sys
import tomllib
from itertools import islice
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter

import cv2
import numpy as np
import pandas
from timing import FAST, report

from silpose.app.compose import build_components
from silpose.app.config import load
from silpose.core.pose_space import ANGLES
from silpose.core.skeleton import POINTS
from silpose.experiments.video_model import video_model
from silpose.model.video import FilmMasks, Placement, fit_film
from silpose.motion import WalkerTakes
from silpose.silhouette import Body, Camera, render
from silpose.silhouette.video import VideoMasks

FILMS = Path(__file__).parents[2] / "shared" / "video"
ENVIRONMENTS = [argument for argument in sys.argv[1:] if not argument.startswith("--")]
RATE = 30
BEGINNING = 10  # frames
SMALL = (
    *("motion.seconds=3", "motion.test_seconds=3", "silhouette.scenes.frames=400"),
    *("descriptor.codebook_size=60", "fitting.iterations=4", "fitting.starts=1"),
)
LIMBS = ("shoulder", "elbow", "wrist", "hip", "knee", "ankle")
COMPARED = [POINTS.index(f"{side}_{joint}") for joint in LIMBS for side in ("left", "right")]


def rendered_film(folder):
    """Film a walker who passes a camera at rest before a wall; return the file and its joints."""
    turns = {"turns": 0.05, "test_turns": 0.05, "frames_per_second": RATE}
    walk = WalkerTakes(seconds=2, test_seconds=2, **turns).takes()[-1]
    camera = Camera(1.2, 3.0, 5.0, width=640, height=352, follow=False)
    way = walk.root_position - walk.root_position.mean(axis=0)
    azimuth = np.rad2deg(np.arctan2(*(way[-1] - way[0])[[0, 2]])) + 90
    camera = Camera(1.2, 3.0, 5.0, width=640, height=352, follow=False, azimuth=azimuth)
    offset, heading = camera.place(walk.root_position, walk.angles[:, 0])
    x = ANGLES.from_angles(np.column_stack([heading, walk.angles[:, 1:]]))
    rng = np.random.default_rng(0)
    wall = cv2.resize(rng.uniform(90, 190, (9, 16, 3)), (640, 352), interpolation=cv2.INTER_CUBIC)
    file, codec = folder / "walk.mp4", cv2.VideoWriter.fourcc(*"mp4v")
    writer = cv2.VideoWriter(str(file), codec, RATE, (640, 352))
    for mask in render(Body(), camera, ANGLES.rotations(x), offset):
        picture = np.where(mask[..., None] > 0, (60.0, 50.0, 140.0), wall)
        writer.write((picture + rng.normal(0, 2, picture.shape)).clip(0, 255).astype(np.uint8))
    writer.release()
    return file, ANGLES.joints(x)


def balance_joints():
    """Read the true joints of balance, as `Poses.joints`; NaN where there is none."""
    folder = FILMS / "balance"
    lines = (folder / "reference.trc").read_text().splitlines()
    names = [name for name in lines[3].split("\t")[2:] if name]
    table = pandas.read_csv(folder / "reference.trc", sep="\t", skiprows=5, header=None)
    places = table.iloc[:, 2 : 2 + 3 * len(names)].to_numpy(float).reshape(-1, len(names), 3)
    calibration = tomllib.loads((folder / "calibration.toml").read_text())["cam_04"]
    turn = cv2.Rodrigues(np.array(calibration["rotation"]))[0]
    camera = (-turn.T @ np.array(calibration["translation"]))[[1, 2, 0]]  # z, x, y of the world
    root = places[:, [names.index("RHip"), names.index("LHip")]].mean(axis=1)
    joints = np.full((len(places), len(POINTS), 3), np.nan)
    for number, point in enumerate(POINTS):
        side, _, joint = point.partition("_")
        if (name := f"{side[0].upper()}{joint.capitalize()}") in names:
            joints[:, number] = places[:, names.index(name)] - root
    ahead = (camera - root) * (1, 0, 1)
    ahead /= np.linalg.norm(ahead, axis=1, keepdims=True)
    up = np.array([0.0, 1.0, 0.0])
    axes = np.stack([np.cross(up, ahead), np.broadcast_to(up, ahead.shape), ahead], axis=1)
    return np.einsum("fij,fkj->fki", axes, joints)


def aligned(estimated, true):
    """Turn, move and scale joints (J, 3) onto the true ones."""
    one, other = (own - own.mean(axis=0) for own in (estimated, true))
    u, s, v = np.linalg.svd(one.T @ other)
    sign = np.array([1, 1, np.sign(np.linalg.det(u @ v))])
    return (s * sign).sum() / (one**2).sum() * one @ (u * sign) @ v + true.mean(axis=0)


def errors(estimated, true):
    """MPJPE from the middle of the hips, and PA-MPJPE, of joints (F, 23, 3), millimetres."""
    known = np.isfinite(true[:, COMPARED]).all(axis=(1, 2)) & np.isfinite(estimated[:, 0, 0])
    hips = [POINTS.index("left_hip"), POINTS.index("right_hip")]
    one, other = (
        own[known][:, COMPARED] - own[known][:, hips].mean(axis=1, keepdims=True)
        for own in (estimated, true)
    )
    fitted = np.stack([aligned(*pair) for pair in zip(one, other, strict=True)])
    return [1000 * np.linalg.norm(own - other, axis=2).mean() for own in (one, fitted)]


def measured(model, name, file, true=None, **options):
    """Segment and fit a film; return a row of what came out."""
    started = perf_counter()
    film = FilmMasks.read(VideoMasks(file, **options))
    masked = perf_counter()
    track = fit_film(model, film, Placement.of(model, film.shape)).track
    took = perf_counter() - masked
    poses = track.poses
    apart = [poses.joints[:, POINTS.index(f"{side}_ankle"), 0] for side in ("left", "right")]
    found = (
        ["", ""] if true is None else [f"{e:.0f}" for e in errors(poses.joints, true[track.index])]
    )
    return [
        f"{name}, {len(film)} frames", f"{np.nanmedian(poses.iou):.3f}",
        f"{np.nanmin(poses.iou):.3f}", f"{np.nanmedian(poses.heading):.0f}",
        f"{np.nanmedian(np.abs(apart[0] - apart[1])):.2f}", *found,
        f"{len(film) / (masked - started):.0f}", f"{len(film) / took:.0f}",
    ]  # fmt: skip


def live_rates(model, file, **options):
    """Frames per second from the file to a pose, decoding and segmentation included.

    What is done once is not counted: the background is learnt and code is loaded by the first
    frames.
    """
    rates = []
    for fit in (False, True):
        stream, frames = model.stream(fit=fit), iter(VideoMasks(file, **options))
        for frame in islice(frames, BEGINNING):
            stream.step(frame.mask, frame.time)
        started, count = perf_counter(), 0
        for frame in frames:
            stream.step(frame.mask, frame.time)
            count += 1
        rates.append(count / (perf_counter() - started))
    return rates


MEDIAPIPE = """
import sys, time, cv2
from mediapipe import solutions
film, first, last, beginning = cv2.VideoCapture(sys.argv[1]), *map(int, sys.argv[2:])
for _ in range(first):
    film.grab()
with solutions.pose.Pose() as pose:
    for count in range(last - first + 1):
        if count == beginning:
            started = time.perf_counter()
        picture = film.read()[1]
        pose.process(cv2.cvtColor(picture, cv2.COLOR_BGR2RGB))
print((count + 1 - beginning) / (time.perf_counter() - started))
"""


def mediapipe_rate(environment, file, first=0, last=0):
    """Measure MediaPipe Pose likewise, decoding included, with the model that its wheel carries."""
    last = last or int(cv2.VideoCapture(str(file)).get(cv2.CAP_PROP_FRAME_COUNT)) - 1
    given = [str(value) for value in (file, first, last, BEGINNING)]
    command = [Path(environment) / "bin" / "python", "-c", MEDIAPIPE, *given]
    return float(subprocess.run(command, capture_output=True, check=True, text=True).stdout)


if __name__ == "__main__":
    with TemporaryDirectory() as folder:
        small = SMALL if FAST else ()
        components = build_components(load(["experiment=video", "silhouette.source=x", *small]))
        model = video_model(components, None, folder if FAST else None).model
        rows = []
        if FILMS.is_dir():
            walk = FILMS / "walkgait" / "walk.mp4"
            part = {"first": 20, "last": 44 if FAST else 120}
            rows.append(measured(model, "walkgait", walk, **part))
            if not FAST:
                scene = str(FILMS / "balance" / "cam04_background.png")
                film = FILMS / "balance" / "cam04.mp4"
                rows.append(measured(model, "balance", film, balance_joints(), background=scene))
        if FAST or not FILMS.is_dir():
            file, true = rendered_film(Path(folder))
            rows.append(measured(model, "rendered", file, true, last=24 if FAST else None))
            walk, part = file, {}
        plain, fitted = live_rates(model, walk, **part)
        rates = [["estimated, tracked", plain], ["fitted live", fitted]]
        rates += [["MediaPipe Pose", mediapipe_rate(own, walk, **part)] for own in ENVIRONMENTS]
    titles = ["film", "overlap", "least", "heading", "ankles apart, m", "MPJPE, mm", "PA-MPJPE"]
    report("Films, fitted as a whole", [*titles, "masks a second", "fits a second"], rows)
    speeds = [[name, f"{rate:.0f}"] for name, rate in rates]
    report("From film to pose at 640x352; asked: 200 and 60", ["", "frames a second"], speeds)

"""How well fitted poses give the parameters of gait: python benchmarks/gait.py [FOLDER] [--fast].

A camera at rest sees unseen walkers at 30 frames per second, or, where FOLDER holds captured motion
as BVH, its test takes. Poses by regression and by fits of the masks are held against the true ones,
with the path that the masks were rendered with, and without any.
"""

import sys

import numpy as np
from timing import FAST, report

from silpose.app.compose import build_components
from silpose.app.config import load
from silpose.evaluation.gait import Walk, azimuth_of_camera, gait_report
from silpose.experiments.setup import prepare_fitting, prepare_tracking

RATE = 30
NAMES = ("cadence", "stride_time", "stride_length", "speed", "stance", "double_support")


def settings(folders: list[str]) -> list[str]:
    """List settings of a camera at rest that is far enough to see all of the way."""
    seconds = [f"motion.seconds={4 if FAST else 12}", f"motion.test_seconds={5 if FAST else 10}"]
    seconds += ["motion.turns=4", f"motion.test_turns={0.5 if FAST else 1.3}"]  # ways of few metres
    captured = [f"motion.root={folder}" for folder in folders]
    source = ["motion=bvh", *captured, "dataset=cross_performer"] if folders else seconds
    camera = ["silhouette.camera.follow=false", "silhouette.camera.distance=12"]
    camera += [f"silhouette.camera.{side}={192 if FAST else 320}" for side in ("width", "height")]
    small = [f"silhouette.scenes.frames={400 if FAST else 1500}"]
    return ["experiment=fitting", f"motion.frames_per_second={RATE}", *source, *camera, *small]


def gait_of(x, take, camera, with_path):
    """Report of poses of a take."""
    return gait_report(
        Walk.from_poses(
            x,
            frames_per_second=RATE,
            path=take.offset if with_path else None,
            camera_azimuth=azimuth_of_camera(take.offset, camera.position),
        )
    )


if __name__ == "__main__":
    folders = [argument for argument in sys.argv[1:] if argument != "--fast"][:1]
    components = build_components(load(settings(folders)))
    training = prepare_tracking(components)
    described = training.described
    fits = prepare_fitting(components, described, training.ridge, training.tracker)
    errors: dict[str, list[list[float]]] = {}
    reasons: set[str] = set()
    for take, (z, x) in zip(described.data.test, described.test, strict=True):
        camera = take.camera_or(components.camera)
        mean, neighbours = fits.starts(z)
        tracked = training.tracker.track(z, lag=training.lag).x
        fitter = fits.fitter(
            camera=camera, camera_is="known", shape_is="known", whole_take=True,
            prior=fits.tracked_prior,
        )  # fmt: skip
        fit = fitter.fit(
            list(take.mask_array()), tracked, others=np.concatenate([mean[:, None], neighbours], 1),
            roots=take.offset, frames_per_second=RATE,
        )  # fmt: skip
        poses = {"true poses": x, "ridge": mean, "tracker_lag": tracked, "fitted_take": fit.x}
        true = gait_of(x, take, camera, True)
        for method, own in poses.items():
            for given in (True, False):
                seen = gait_of(own, take, camera, given)
                label = f"{method}, {'path' if given else 'no path'}"
                reasons.update({f"{label}: {p.reason}" for p in seen.parameters if p.reason})
                errors.setdefault(label, []).append(
                    [100 * abs(seen[n].value / true[n].value - 1) for n in NAMES]
                )
    rows = []
    for label, own in errors.items():
        found = [each for each in own if np.isfinite(each).all()]
        middle = [f"{e:.1f}" for e in np.median(found, axis=0)] if found else ["–"] * len(NAMES)
        rows.append([label, *middle, str(len(own) - len(found))])
    titles = [name.replace("_", " ") for name in NAMES]
    title = f"Median errors, percent, over {len(described.data.test)} takes, and takes without any"
    report(title, ["poses", *titles, "none"], rows)
    print(*sorted(reasons), sep="\n")

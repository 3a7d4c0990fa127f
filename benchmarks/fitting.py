"""How long it takes to fit a body to masks: python benchmarks/fitting.py [--fast].

A body walks before the camera; estimates of its poses err by some degrees in every angle.
"""

from time import perf_counter

import cv2
import numpy as np
from threadpoolctl import threadpool_limits
from timing import FAST, ROUNDS, report

from silpose.core.pose_space import ANGLES
from silpose.fitting import BodyFitter, FitterStream, PosePrior
from silpose.fitting.contour import contour_of
from silpose.fitting.frame_fit import Gaussian, fit_frame
from silpose.fitting.geometry import geometry_of
from silpose.fitting.likelihood import Observation
from silpose.motion import WalkerTakes
from silpose.silhouette import Body, Camera, render

ERROR_DEG = 4.0
SIZES = (256,) if FAST else (256, 512)


def milliseconds(work, count):
    """Time of one piece of work, best of some rounds after a first one to warm up."""
    work()
    took = []
    for _ in range(ROUNDS):
        started = perf_counter()
        work()
        took.append(1000 * (perf_counter() - started) / count)
    return f"{min(took):.2f}"


def erring(x, rng):
    """Estimates of poses that err in every angle."""
    return ANGLES.from_angles(ANGLES.angles(x) + rng.normal(0, ERROR_DEG, (len(x), 54)))


if __name__ == "__main__":
    rng = np.random.default_rng(0)
    *train, last = (
        ANGLES.from_angles(take.angles) for take in WalkerTakes(seconds=8, test_seconds=8).takes()
    )
    prior = PosePrior.from_errors(train, [erring(x, rng) for x in train], 15.0)
    x = last[: 12 if FAST else 60]
    start, body = erring(x, rng), Body()
    rows = []
    cv2.setNumThreads(1)
    for size in SIZES:
        camera = Camera(width=size, height=size)
        masks = list(render(body, camera, ANGLES.rotations(x)))
        with threadpool_limits(1):
            fitter = BodyFitter(body, camera, prior)
            contours = [contour_of(mask) for mask in masks]
            angles, geometry = np.deg2rad(ANGLES.angles(start)), geometry_of(body)

            def frames(iterations, angles=angles, fitter=fitter, contours=contours, g=geometry):
                for mean, contour in zip(angles, contours, strict=True):
                    around = Gaussian(mean, prior.precision)
                    seen = Observation(contour, np.zeros(3), g, fitter.view, fitter.matching)
                    fit_frame(mean, around, seen, iterations, 0)

            def live(fitter=fitter, masks=masks):
                stream = FitterStream(fitter)
                for mask, pose in zip(masks, start, strict=True):
                    stream.step(mask, pose)

            free = BodyFitter(body, camera, prior, camera_is="estimated", shape_is="estimated")
            measured = {
                "contour of a mask": lambda m=masks: [contour_of(mask) for mask in m],
                "frame and start, 4 iterations": lambda f=frames: f(4),
                "frame and start, 10 iterations at most": lambda f=frames: f(10),
                "live step": live,
                "frame of a take": lambda f=fitter, m=masks: f.fit(m, start),
                "the same, camera and shape estimated": lambda f=free, m=masks: f.fit(m, start),
            }
            rows += [
                [f"{what}, {size}x{size}", milliseconds(work, len(masks))]
                for what, work in measured.items()
            ]
    report(f"fitting to {len(x)} masks, one core", ["what", "milliseconds"], rows)

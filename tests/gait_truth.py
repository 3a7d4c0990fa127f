"""True strides from the contact of heels and toes with the ground, for holding reports against.

A foot is on the ground while it hardly moves in the world, which has nothing to do with how far it
is in front of the hips. Works on motion as it was recorded, at its own rate.
"""

from itertools import pairwise

import numpy as np

from silpose.core import skeleton

RESTING = 0.5  # share of the median speed of walking below which a point of a foot rests


def world_feet(motion):
    """Heel, ankle and toes of a `Motion` in the world, by name, each (F, 3), and the root."""
    places, turned = skeleton.forward_kinematics(skeleton.rotations_from_angles(motion.angles))
    feet = {"root": motion.root_position}
    for side in ("left", "right"):
        ankle = f"{side}_ankle"
        feet[ankle] = places[:, skeleton.POINTS.index(ankle)] + motion.root_position
        sole = turned[:, skeleton.JOINTS.index(ankle)]
        for name, offset in zip(("heel", "toes"), skeleton.SOLES[ankle], strict=True):
            feet[f"{side}_{name}"] = feet[ankle] + sole @ offset
    return feet


def source_feet(source):
    """Feet of a `SourceMotion` as the file has them, whose heel is below and behind the ankle."""
    feet = {"root": source.positions["root"]}
    for side in ("left", "right"):
        ankle, toes = source.positions[f"{side}_ankle"], source.positions[f"{side}_toes"]
        back = (ankle - toes) * (1.0, 0.0, 1.0)
        feet |= {f"{side}_ankle": ankle, f"{side}_toes": toes, f"{side}_heel": ankle + 0.3 * back}
    return feet


def contacts(point, rate, speed):
    """Times at which a point (F, 3) comes to rest, and leaves again, between frames; seconds."""
    velocity = np.linalg.norm(np.gradient(point, 1 / rate, axis=0)[:, [0, 2]], axis=1)
    above = velocity - RESTING * speed
    k = np.flatnonzero(np.signbit(above[:-1]) != np.signbit(above[1:]))
    at = (k + above[k] / (above[k] - above[k + 1])) / rate
    down = above[k] > 0
    # Rest of less than a tenth of a second is none, and so is a movement of less than that.
    kept = np.ones(len(at), bool)
    j = 0
    while j < len(at) - 1:
        if kept[j] and at[j + 1] - at[j] < 0.1:
            kept[j] = kept[j + 1] = False
            j += 1
        j += 1
    return at[kept & down], at[kept & ~down]


def true_strides(feet, rate):
    """Strides as (side, start, end, length), in seconds and metres, by contact with the ground."""
    ground = feet["root"][:, [0, 2]]
    speed = np.median(np.linalg.norm(np.gradient(ground, 1 / rate, axis=0), axis=1))
    strides = []
    for side in ("left", "right"):
        strikes, _ = contacts(feet[f"{side}_heel"], rate, speed)
        _, offs = contacts(feet[f"{side}_toes"], rate, speed)
        for start, end in pairwise(strikes):
            if not 0.7 < end - start < 2.2 or ((offs > start) & (offs < end)).sum() != 1:
                continue
            places = []
            for strike in (start, end):
                first = round((strike + 0.1 * (end - start)) * rate)
                last = first + max(1, round(0.2 * (end - start) * rate))
                flat = feet[f"{side}_ankle"][first:last]
                places.append(np.median(flat, axis=0) if len(flat) else np.full(3, np.nan))
            length = np.linalg.norm((places[1] - places[0])[[0, 2]])
            strides.append((side, start, end, length))
    return strides


def gait_errors(report, truth):
    """Errors of cadence, stride time and stride length, percent, of the means over a take.

    Cadence is compared with all true strides; time and length over those found on either side.
    """
    pairs = []
    for stride in report.counted:
        for side, start, end, length in truth:
            near = max(abs(stride.start - start), abs(stride.end - end)) < 0.3
            if side == stride.side and near and np.isfinite(length):
                pairs.append((stride.seconds, end - start, stride.length, length))
    seconds, true_seconds, length, true_length = np.mean(pairs, axis=0)
    cadence = 120 / np.mean([end - start for _, start, end, _ in truth])
    return {
        "cadence": 100 * (report["cadence"].value / cadence - 1),
        "stride_time": 100 * (seconds / true_seconds - 1),
        "stride_length": 100 * (length / true_length - 1),
    }

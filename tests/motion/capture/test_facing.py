from dataclasses import replace

from silpose.motion.capture.facing import Facing, find_facing


def test_knees_feet_and_travel_agree_in_a_walk(walking):
    facing = find_facing(walking(), 30)
    assert facing.forwards == {"knees": True, "feet": True, "travel": True}
    assert facing.known and not facing.reversed and str(facing) == "knees and feet"


def test_walking_backwards_is_no_mirror_image(walking):
    facing = find_facing(walking(backwards=True), 30)
    assert facing.forwards == {"knees": True, "feet": True, "travel": False}
    assert not facing.reversed


def test_a_mirror_image_is_told(walking, mirrored):
    for toes in (True, False):
        facing = find_facing(mirrored(walking(toes=toes)), 30)
        assert facing.reversed and facing.known


def test_stiff_legs_without_toes_tell_nothing(walking):
    motion = walking(toes=False)
    places = dict(motion.positions)
    for side in ("left", "right"):
        places[f"{side}_knee"] = (places[f"{side}_hip"] + places[f"{side}_ankle"]) / 2
    facing = find_facing(replace(motion, positions=places), 30)
    assert not facing.known and not facing.reversed
    assert facing.forwards == {"travel": True} and "names" in str(facing)


def test_a_single_frame_tells_no_travel(walking):
    facing = find_facing(walking()[:1], 30)
    assert "travel" not in facing.forwards and facing.forwards["feet"]


def test_knees_decide_if_feet_disagree():
    facing = Facing({"knees": False, "feet": True})
    assert facing.contradictory and facing.reversed and facing.decided_by == "knees"
    assert not Facing({"feet": True}).contradictory and Facing({"feet": False}).reversed

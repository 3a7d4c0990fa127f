from walk_checks import read
from walk_files import WalkFile


def test_a_report_says_what_was_understood(tmp_path):
    report = read(WalkFile(frames=91, turning=20, unit=0.0254), tmp_path).report
    assert report.joints["left_knee"] == "LeftLeg" and report.how["left_knee"] == "by name"
    assert (report.frames, report.source_rate, report.frames_per_second) == (91, 30.0, 30.0)
    assert 20 < report.leg_length * report.metres_per_unit * 100 / 3 < 30
    assert 1.2 < report.body_height < 1.6
    assert 55 < report.heading_change < 65
    assert 1.2 < report.speed < 1.6 and 0.85 < report.strides_per_second < 0.95


def test_an_estimated_rest_pose_is_told_with_its_uncertainty(tmp_path):
    report = read(WalkFile(rest="random", stoop=40), tmp_path).report
    assert report.rest_uncertainty == 12
    assert "no rest pose" in report.assumed[0] and "12 degrees" in report.assumed[0]
    assert report.notes == ()

import subprocess
import sys

HEAVY = ("mannequin", "cv2", "pybvh", "rerun", "hydra", "matplotlib")


def test_importing_trackers_loads_only_what_they_need():
    code = f"import sys, silpose.tracking; print([m for m in {HEAVY} if m in sys.modules])"
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert found.stdout.strip() == "[]"


def test_every_public_name_is_there():
    import silpose.tracking as tracking

    assert tracking.__all__ == sorted(tracking.__all__, key=lambda n: (not n.isupper(), n))
    assert all(hasattr(tracking, name) for name in tracking.__all__)

import subprocess
import sys

HEAVY = ("mannequin", "cv2", "pybvh", "rerun", "hydra", "matplotlib")
OTHERS = ("motion", "silhouette", "dataset", "descriptor", "tracking", "evaluation", "recording")


def test_regression_loads_no_other_package_and_none_of_the_heavy_libraries():
    code = "import sys, silpose.regression; print(*sys.modules)"
    result = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True
    )
    loaded = set(result.stdout.split())
    assert "silpose.regression" in loaded
    assert not loaded & {*HEAVY, *(f"silpose.{name}" for name in OTHERS)}

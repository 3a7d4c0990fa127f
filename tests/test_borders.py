"""Whatever comes in at the borders: a documented error, or something usable, within a second.

Hundreds of inputs each; ``pytest --hypothesis-profile=long tests/test_borders.py`` tries ten
thousand.
"""

import copy
import io
import json
import time
import warnings

import cv2
import numpy as np
import pytest
from damaged import damaged, reworded
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from PIL import Image
from walk_files import WalkFile

import silpose
from silpose.app.build import build
from silpose.app.config import load
from silpose.app.registry import COMPONENTS
from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.model import PoseModel
from silpose.motion.capture.formats.read_raw import read_raw
from silpose.motion.capture.options import CaptureOptions
from silpose.motion.capture.take import read_take
from silpose.regression import RidgeRegressor
from silpose.silhouette.masks import read_masks

pytestmark = pytest.mark.filterwarnings("ignore")
ANY = settings(suppress_health_check=list(HealthCheck), deadline=None)
LONGEST = 1.0  # seconds of one processor


@pytest.fixture(scope="module")
def place(tmp_path_factory):
    return tmp_path_factory.mktemp("borders")


def tried(read, file, content):
    """Read a file of that content; None where it is refused in one sentence."""
    file.write_bytes(content)
    began = time.process_time()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            return read(file)
        except InputError as error:
            assert file.stem in str(error) and "\n" not in str(error)
            return None
        finally:
            assert time.process_time() - began < LONGEST


@pytest.fixture(scope="module")
def walk(tmp_path_factory):
    file = tmp_path_factory.mktemp("walk") / "a.bvh"
    WalkFile(frames=12).write(file)
    return file.read_text()


@ANY
@given(data=st.data())
def test_bvh(place, walk, data):
    text = data.draw(reworded(walk)).encode(errors="replace")
    content = data.draw(st.one_of(st.just(text), damaged(text)))
    taken = tried(lambda f: read_take(f, CaptureOptions()), place / "odd.bvh", content)
    if taken is not None:
        assert np.isfinite(taken.angles).all() and np.isfinite(taken.root_position).all()


ASF = """\
:version 1.10
:units
  length 0.45
  angle deg
:root
  order TX TY TZ RX RY RZ
  axis XYZ
  position 0 0 0
  orientation 0 0 0
:bonedata
  begin
    id 1
    name spine
    direction 0 1 0
    length 2.0
    axis 10 20 30 XYZ
    dof rx ry rz
    limits (-160.0 20.0)
           (-70.0 70.0)
           (-70.0 70.0)
  end
  begin
    id 2
    name skull
    direction 0 1 0.1
    length 1.0
    axis 0 0 0 XYZ
  end
:hierarchy
  begin
    root spine
    spine skull
  end
"""
AMC = ":FULLY-SPECIFIED\n:DEGREES\n" + "".join(
    f"{frame}\nroot 0.1 {frame} 3.5 10 20 30\nspine 4 5 {frame}\n" for frame in range(1, 4)
)


@ANY
@given(data=st.data(), spoiled=st.sampled_from(["asf", "amc"]))
def test_asf_amc(place, data, spoiled):
    texts = {"asf": ASF, "amc": AMC}
    text = data.draw(reworded(texts[spoiled])).encode(errors="replace")
    content = data.draw(st.one_of(st.just(text), damaged(text)))
    for kind, whole in texts.items():
        (place / f"odd.{kind}").write_bytes(content if kind == spoiled else whole.encode())
    raw = tried(read_raw, place / "odd.amc", (place / "odd.amc").read_bytes())
    if raw is not None:
        assert np.isfinite(raw.positions).all() and np.isfinite(raw.rotations).all()


def archive(arrays):
    stored = io.BytesIO()
    np.savez(stored, **arrays)
    return stored.getvalue()


AMASS = {
    "poses": np.full((9, 66), 0.1),
    "trans": np.zeros((9, 3)),
    "mocap_framerate": np.array(60.0),
    "gender": np.array("neutral"),
}
ODD_ARRAYS = st.one_of(
    st.sampled_from([np.array("x"), np.array(True), np.array(1j), np.empty((0, 3))]),
    st.builds(
        lambda shape, value, kind: np.full(shape, value).astype(kind),
        st.lists(st.sampled_from([0, 1, 3, 9, 66, 67]), max_size=3),
        st.sampled_from([0.0, 1.0, -1.0, 7.0, 1e5, 1e30, np.nan, np.inf, 0.01]),
        st.sampled_from(["f8", "f4", "f2", "i4", "u1", "?", "U3", "M8[s]"]),
    ),
)


@ANY
@given(data=st.data())
def test_amass(place, data):
    names = st.sampled_from([*AMASS, "root_orient", "pose_body", "fps", "transl"])
    with np.errstate(all="ignore"):
        odd = data.draw(st.dictionaries(names, ODD_ARRAYS, max_size=2))
    kept = {name: AMASS[name] for name in AMASS if data.draw(st.integers(0, 9)) > 0}
    content = archive(kept | odd)
    content = data.draw(st.one_of(st.just(content), damaged(content)))
    raw = tried(read_raw, place / "odd.npz", content)
    if raw is not None:
        assert np.isfinite(raw.positions).all() and np.isfinite(raw.rotations).all()
        assert np.isfinite(raw.frames_per_second) and raw.frames_per_second > 0


def pictures():
    """A mask in files of every kind."""
    mask = np.zeros((24, 16), np.uint8)
    mask[4:20, 5:11] = 255
    image = Image.fromarray(mask)
    for kind in ("PNG", "JPEG", "GIF", "TIFF", "BMP", "WEBP", "PPM"):
        stored = io.BytesIO()
        image.save(stored, kind)
        yield f"odd.{kind.lower()}", stored.getvalue()
    stored = io.BytesIO()
    image.save(stored, "GIF", save_all=True, append_images=[image.rotate(30)], duration=40)
    yield "odd.gif", stored.getvalue()
    stored = io.BytesIO()
    np.save(stored, np.stack([mask, mask]))
    yield "odd.npy", stored.getvalue()
    yield "odd.npz", archive({"masks": np.stack([mask, mask])})
    runs = {"segmentation": {"size": [24, 16], "counts": [124, 16, 8, 16, 220]}, "image_id": 1}
    yield "odd.json", json.dumps([runs, runs]).encode()


PICTURES = list(pictures())


@ANY
@given(data=st.data(), picture=st.sampled_from(PICTURES))
def test_masks(place, data, picture):
    name, content = picture
    changed = damaged(content)
    if name.endswith("json"):
        changed = reworded(content.decode()).map(lambda text: text.encode())
    masks = tried(read_masks, place / name, data.draw(changed))
    if masks is not None:
        assert len(masks) and all(mask.dtype == np.uint8 and mask.max() <= 1 for mask in masks)


VALUES = st.recursive(
    st.one_of(
        st.none(), st.booleans(), st.integers(-2, 10**12), st.floats(), st.text(max_size=5),
        st.sampled_from(["auto", "a.b", "${seed}", "???", "os.system"]),
    ),
    lambda inner: st.lists(inner, max_size=2)
    | st.dictionaries(st.sampled_from(["kind", "_target_", "x"]), inner, max_size=2),
    max_leaves=3,
)  # fmt: skip
RUNS = {"size": [8, 6], "counts": [10, 4, 34]}
CORNERS = [1, 1, 4, 1, 4, 6]
JSON = {
    "coco": {
        "images": [{"id": k, "file_name": f"{k}.jpg", "height": 8, "width": 6} for k in (1, 2)],
        "categories": [{"id": 1, "name": "person"}],
        "annotations": [
            {"image_id": 1, "category_id": 1, "segmentation": [CORNERS], "score": 0.9},
            {"image_id": 2, "category_id": 1, "segmentation": RUNS, "track_id": 1},
        ],
    },
    "results": [{"image_id": 1, "category_id": 0, "segmentation": RUNS, "score": 0.9}],
    "runs": [RUNS, None],
    "by_frame": {"0": {"1": RUNS}, "1": {}},
    "vis": {"images": [], "annotations": [{"video_id": 1, "segmentations": [RUNS, None]}]},
    "labelme": {
        "imagePath": "a.jpg", "imageHeight": 8, "imageWidth": 6, "imageData": None,
        "shapes": [{"label": "person", "points": [[1, 1], [4, 1], [4, 6]], "group_id": None,
                    "shape_type": "polygon"}],
    },
    "own": {"image_path": "a.jpg", "img_height": 8, "img_width": 6,
            "annotations": [{"class_name": "person", "segmentation": RUNS, "score": [0.9]}]},
}  # fmt: skip


@st.composite
def changed_json(draw, content):
    """Put something else into one place of what JSON holds."""
    content = copy.deepcopy(content)
    inside = content
    while True:
        key = draw(st.sampled_from([*inside] if isinstance(inside, dict) else range(len(inside))))
        deeper = inside[key]
        if not (isinstance(deeper, dict | list) and deeper) or draw(st.integers(0, 3)) == 0:
            break
        inside = deeper
    inside[key] = draw(VALUES)
    return content


@ANY
@given(data=st.data(), form=st.sampled_from(sorted(JSON)))
def test_masks_in_json(place, data, form):
    text = json.dumps(data.draw(changed_json(JSON[form])))
    masks = tried(read_masks, place / "odd.json", text.encode())
    assert masks is None or all(mask.dtype == np.uint8 for mask in masks)


@pytest.fixture(scope="module", params=["odd.mp4", "odd.avi"])
def film(tmp_path_factory, request):
    file = tmp_path_factory.mktemp("film") / request.param
    codec = "mp4v" if file.suffix == ".mp4" else "MJPG"
    writer = cv2.VideoWriter(str(file), cv2.VideoWriter.fourcc(*codec), 25, (32, 48))
    for frame in range(4):
        picture = np.zeros((48, 32, 3), np.uint8)
        picture[8:40, 8 + frame : 20 + frame] = 255
        writer.write(picture)
    writer.release()
    with pytest.MonkeyPatch.context() as patch:  # a process for each would take hours
        patch.setattr("silpose.silhouette.masks.decoder_errors.sys.executable", "/no/such/python")
        yield file.name, file.read_bytes()


@ANY
@given(data=st.data())
def test_video(place, film, data):
    name, content = film
    masks = tried(read_masks, place / name, data.draw(damaged(content)))
    assert masks is None or len(masks) > 0


@pytest.fixture(scope="module")
def model(tmp_path_factory):
    """Bytes of a saved model and what it predicts."""
    rng = np.random.default_rng(0)
    z, x = rng.random((30, 8)), rng.random((30, 54))
    file = tmp_path_factory.mktemp("model") / "odd.npz"
    PoseModel(None, RidgeRegressor().fit(z, x), ANGLES, 15.0).save(file)
    return file.read_bytes(), z, silpose.load(file).explain_descriptors(z).x


def is_identical(file, z, expected):
    return np.array_equal(silpose.load(file).explain_descriptors(z).x, expected)


@ANY
@given(data=st.data())
def test_a_model_that_is_damaged_is_refused_or_the_same(place, model, data):
    content, z, expected = model
    changed = data.draw(damaged(content))
    assert tried(lambda f: is_identical(f, z, expected), place / "odd.npz", changed) in (None, True)


@ANY
@given(data=st.data())
def test_a_model_whose_arrays_were_changed_is_refused_or_the_same(place, model, data):
    content, z, expected = model
    arrays = dict(np.load(io.BytesIO(content)))
    name, other = (data.draw(st.sampled_from(sorted(arrays))) for _ in range(2))
    kind = data.draw(st.sampled_from(["swap", "drop", "replace"]))
    if kind == "swap":
        arrays[name], arrays[other] = arrays[other], arrays[name]
    elif kind == "drop":
        del arrays[name]
    else:
        with np.errstate(all="ignore"):
            arrays[name] = data.draw(ODD_ARRAYS)
    file = place / "odd.npz"
    assert tried(lambda f: is_identical(f, z, expected), file, archive(arrays)) in (None, True)


GROUPS = sorted(set(COMPONENTS) - {"", "recording"})


@ANY
@given(data=st.data(), group=st.sampled_from(GROUPS))
def test_settings(data, group):
    known = sorted(COMPONENTS[group].settings)
    names = st.sampled_from([*known, "_target_", "kind", "nothing"])
    odd = data.draw(st.dictionaries(names, VALUES, min_size=1, max_size=2))
    try:
        build(group, odd)
    except InputError as error:
        assert "\n" not in str(error)
    except TypeError as error:  # what a run gives besides settings is missing here
        assume("required" not in str(error))
        raise


OVERRIDES = "seed=1 regression.rvm.nu=3 motion=bvh +x=[1,2] ~seed motion.root='a b' n_jobs={a:1}"


@settings(ANY, max_examples=max(20, ANY.max_examples // 5))  # each composes all of a config
@given(text=reworded(OVERRIDES))
def test_overrides(text):
    try:
        load(text.split())
    except InputError as error:
        assert "\n" not in str(error)

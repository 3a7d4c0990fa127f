"""Masks as people really have them, each showing the same twelve silhouettes."""

import warnings
from pathlib import Path

import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette import MaskSource, read_masks

FIELD = Path(__file__).parents[4] / "shared" / "field" / "masks"

pytestmark = [
    pytest.mark.shared,
    pytest.mark.skipif(not FIELD.is_dir(), reason="the field cases are not on this machine"),
]

SAME = (
    *("clean_0_1", "clean_0_255", "jpeg_q75", "mog2_shadow_127_png", "names_seconds"),
    *("palette_davis_one", "part_labels_1_6", "rgba_cutout_rembg", "rgba_white_alpha"),
    *("u16_0_1", "u16_mots_2001"),
)


@pytest.fixture(scope="module")
def clean():
    return np.load(FIELD / "truth.npz")["masks"][np.linspace(10, 400, 12).astype(int)]


def overlaps(read, masks):
    return [(a & b).sum() / max((a | b).sum(), 1) for a, b in zip(read, masks, strict=True)]


@pytest.mark.parametrize("case", SAME)
def test_nothing_is_lost(clean, case):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert min(overlaps(read_masks(FIELD / case), clean)) > 0.999


def test_an_animation_is_whole(clean):
    read = read_masks(FIELD / "apng" / "masks.png")
    assert min(overlaps(read, clean)) == 1
    assert read.frames_per_second == pytest.approx(15, rel=0.02)


@pytest.mark.parametrize(
    ("case", "least"), [("soft_alpha", 0.98), ("voc_void_border_palette", 0.98)]
)
def test_edges_are_nearly_the_same(clean, case, least):
    assert min(overlaps(read_masks(FIELD / case), clean)) > least


@pytest.mark.parametrize("case", ["soft_alpha_one_empty", "empty_frames"])
def test_blank_frames_stay_blank(clean, case):
    found = overlaps(read_masks(FIELD / case), clean)
    assert all(overlap == 0 or overlap > 0.98 for overlap in found)
    assert 0 < sum(overlap == 0 for overlap in found) <= 2


@pytest.mark.parametrize(
    ("case", "said"),
    [("inverted_0_255", "background .* is bright"), ("photos_beside_masks", "look like no masks")],
)
def test_a_doubt_is_said(clean, case, said):
    with pytest.warns(UserWarning, match=said):
        assert min(overlaps(read_masks(FIELD / case), clean)) == 1


@pytest.mark.parametrize("case", ["video_mp4v_15", "video_shadow_127"])
def test_videos_have_their_rate_and_no_shadow(case):
    read = read_masks(FIELD / case / "masks.mp4")
    masks = np.load(FIELD / "truth.npz")["masks"][150:270]
    assert read.frames_per_second == 15
    assert min(overlaps(read, masks)) > 0.999


def test_one_of_two_people_is_chosen(clean):
    with pytest.raises(InputError, match=r"has 2 labels, .*silhouette\.label=1"):
        read_masks(FIELD / "palette_davis_two")
    chosen = read_masks(FIELD / "palette_davis_two", MaskSource(label=1))
    assert min(overlaps([mask[:, :256] for mask in chosen], clean)) == 1


@pytest.mark.parametrize(
    ("case", "said"),
    [("photos_only", "look like colour images"), ("coco_rle", "run lengths that cannot be read")],
)
def test_what_is_no_mask_is_refused(case, said):
    with pytest.raises(InputError, match=said):
        read_masks(FIELD / case)


@pytest.mark.parametrize("case", ["gait_128x88", "gait_64x64", "tiny_32px", "tiny_16px"])
def test_small_masks_are_cut_at_half(case):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        read = read_masks(FIELD / case)
    assert all(0.05 < mask.mean() < 0.6 for mask in read)

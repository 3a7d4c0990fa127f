import cv2
import numpy as np
import pytest

from silpose.silhouette.masks import read_masks
from silpose.silhouette.masks.cut_outs import plane_of_cut_outs
from silpose.silhouette.masks.picture import Picture


@pytest.fixture(scope="module")
def clothes(photo):
    """Colours, none of which is that of a background here."""
    return np.clip(photo, 40, 215)


def pictures_of(figures, clothes, colour, lossy=False):
    shown = [np.where(mask[..., None] > 0, clothes, np.uint8(colour)) for mask in figures]
    return [Picture(pixels, f"frame {k}", lossy=lossy) for k, pixels in enumerate(shown)]


@pytest.mark.parametrize("colour", [(0, 0, 0), (255, 255, 255), (0, 250, 4)])
@pytest.mark.parametrize("grey", [False, True])
def test_what_differs_from_one_colour_is_the_person_and_it_is_said(figures, clothes, colour, grey):
    shown = [p.pixels for p in pictures_of(figures, clothes, colour)]
    shown = [p[..., 2] for p in shown] if grey else shown
    with pytest.warns(UserWarning, match="no masks, but pictures before one colour"):
        read = read_masks(np.stack(shown))
    for mask, own in zip(read, figures, strict=True):
        np.testing.assert_array_equal(mask, own)


def test_plain_clothes_are_no_mask_either_where_the_background_is_exact(figures):
    dressed = [np.zeros((*mask.shape, 3), np.uint8) for mask in figures]
    for picture, mask in zip(dressed, figures, strict=True):
        picture[mask > 0] = np.array([[20], [105], [60]])[np.nonzero(mask)[0] // 16]
    held = [Picture(pixels, "it") for pixels in dressed]
    assert plane_of_cut_outs(held) is None
    plane = plane_of_cut_outs(held, no_masks=True)
    for picture, mask in zip(held, figures, strict=True):
        np.testing.assert_array_equal(plane.of(picture), mask)


def test_a_wall_of_a_compressed_photo_is_not_exact(figures, clothes):
    shown = pictures_of(figures, clothes, 200)
    coded = [cv2.imencode(".jpg", p.pixels)[1] for p in shown]
    pictures = [Picture(cv2.imdecode(c, cv2.IMREAD_COLOR), "it", lossy=True) for c in coded]
    assert plane_of_cut_outs(pictures, no_masks=True) is None


def test_a_scene_is_none(figures, clothes, photo):
    noisy = np.random.default_rng(0).integers(0, 60, photo.shape, dtype=np.uint8)
    for scene in (photo, noisy):
        shown = [np.where(mask[..., None] > 0, clothes, scene) for mask in figures]
        assert plane_of_cut_outs([Picture(pixels, "it") for pixels in shown]) is None


@pytest.mark.parametrize("known", [False, True])
@pytest.mark.parametrize("colour", [(0, 0, 0), (255, 255, 255)])
def test_compression_leaves_the_outline(figures, clothes, colour, known):
    """As a file, or as an array, which does not tell that it was compressed."""
    large = [cv2.resize(m, None, fx=4, fy=4, interpolation=cv2.INTER_NEAREST) for m in figures]
    shown = pictures_of(large, cv2.resize(clothes, None, fx=4, fy=4), colour)
    coded = [cv2.imencode(".jpg", p.pixels, [cv2.IMWRITE_JPEG_QUALITY, 85])[1] for p in shown]
    pictures = [Picture(cv2.imdecode(c, cv2.IMREAD_COLOR), "it", lossy=known) for c in coded]
    plane = plane_of_cut_outs(pictures)
    for picture, own in zip(pictures, large, strict=True):
        mask = plane.of(picture)
        assert (mask & own).sum() / (mask | own).sum() > 0.97


@pytest.mark.parametrize("sigma", [0.5, 2, 4])
def test_masks_are_none_however_soft(figures, sigma):
    large = [cv2.resize(255 * m, None, fx=4, fy=4) for m in figures]
    soft = [cv2.GaussianBlur(mask, (0, 0), sigma) for mask in large]
    for pictures in (soft, [255 - mask for mask in soft]):
        assert plane_of_cut_outs([Picture(pixels, "it") for pixels in pictures]) is None


def test_masks_beside_cut_outs_are_taken(figures, clothes, folder_of):
    cut = {f"{k}_photo.png": p.pixels for k, p in enumerate(pictures_of(figures, clothes, 0))}
    folder = folder_of(cut | {f"{k}_mask.png": 255 * mask for k, mask in enumerate(figures)})
    with pytest.warns(UserWarning, match="left out that look like no masks"):
        read = read_masks(folder)
    assert read.names[0] == "0_mask.png" and len(read) == len(figures)

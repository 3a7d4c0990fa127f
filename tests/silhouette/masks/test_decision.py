import cv2
import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette.masks import MaskSource
from silpose.silhouette.masks.decision import decide
from silpose.silhouette.masks.picture import Picture


def read(pictures, lossy=False, **options):
    held = [Picture(pixels, f"frame {k}", lossy=lossy) for k, pixels in enumerate(pictures)]
    encoding = decide(held, MaskSource(**options), "it")
    return [encoding.apply(picture) for picture in held], encoding


def overlap(masks, expected):
    return min((a & b).sum() / max((a | b).sum(), 1) for a, b in zip(masks, expected, strict=True))


@pytest.fixture(scope="module")
def large(figures):
    return [cv2.resize(m, None, fx=4, fy=4, interpolation=cv2.INTER_NEAREST) for m in figures]


@pytest.mark.parametrize("quality", [30, 75, 95])
@pytest.mark.parametrize("grey", [0, 127])
@pytest.mark.parametrize("inverted", [False, True])
@pytest.mark.parametrize("known", [False, True])
def test_compression_and_shadows(large, quality, grey, inverted, known):
    """As a file, or as an array, which does not tell that it was compressed."""
    pictures = []
    for mask in large:
        picture = 255 * mask
        picture[160:180, 20:70][picture[160:180, 20:70] == 0] = grey
        picture = 255 - picture if inverted else picture
        coded = cv2.imencode(".jpg", picture, [cv2.IMWRITE_JPEG_QUALITY, quality])[1]
        pictures.append(cv2.imdecode(coded, cv2.IMREAD_GRAYSCALE))
    masks, encoding = read(pictures, lossy=known)
    assert overlap(masks, large) > 0.99
    assert ("shadows" in encoding.words) == (grey > 0)
    assert bool(encoding.doubts) == inverted


@pytest.mark.parametrize("scale", [1, 255, 4095, 65535, 0.9, 1e6])
def test_soft_edges_of_any_range(large, scale):
    soft = [cv2.GaussianBlur(mask.astype(np.float64), (0, 0), 2) for mask in large]
    kind = float if scale < 2 else np.uint8 if scale < 256 else np.int32
    masks, _ = read([(scale * picture).astype(kind) for picture in soft])
    assert overlap(masks, [picture > 0.5 for picture in soft]) > 0.96


@pytest.mark.parametrize("size", [64, 32, 16])
@pytest.mark.parametrize("inverted", [False, True])
@pytest.mark.parametrize("count", [1, 6])
def test_small_pictures_have_more_edge_than_area(large, size, inverted, count):
    small = [cv2.resize(255 * mask, (size, size), interpolation=cv2.INTER_AREA) for mask in large]
    expected = [(picture > 127).astype(np.uint8) for picture in small]
    pictures = [255 - picture for picture in small] if inverted else small
    masks, _ = read(pictures[:count])
    assert overlap(masks, expected[:count]) == 1


def test_a_blank_picture_stays_blank_among_others(large):
    soft = [cv2.GaussianBlur(255 * mask, (0, 0), 2) for mask in large]
    noise = np.random.default_rng(0).integers(0, 4, soft[0].shape, dtype=np.uint8)
    masks, _ = read([*soft, noise])
    assert not masks[-1].any() and masks[0].any()


def test_scores_are_cut_at_zero(large):
    rng = np.random.default_rng(0)
    scores = [mask * 8.0 - 4 + rng.normal(0, 0.5, mask.shape) for mask in large]
    masks, encoding = read(scores)
    assert overlap(masks, large) == 1 and "above 0" in encoding.words


def test_trimaps_and_depths(large):
    ball = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (9, 9))
    unknown = [cv2.morphologyEx(mask, cv2.MORPH_GRADIENT, ball) for mask in large]
    masks, _ = read(
        [np.where(u, 128, 255 * m).astype(np.uint8) for u, m in zip(unknown, large, strict=True)]
    )
    assert overlap(masks, large) > 0.9
    rng = np.random.default_rng(0)
    masks, _ = read(
        [m * (1500 + rng.integers(-100, 100, m.shape)).astype(np.uint16) for m in large]
    )
    assert overlap(masks, large) == 1


def test_what_the_user_says_counts(figures):
    assert not overlap(read([1 - figures[0]], inverted=False)[0], [figures[0]])
    assert overlap(read([1 - figures[0]], inverted=True)[0], [figures[0]]) == 1
    assert overlap(read([9 * figures[0]], threshold=8)[0], [figures[0]]) == 1
    assert overlap(read([9 * figures[0]], label=9)[0], [figures[0]]) == 1


def test_pictures_of_one_value_are_blank_or_full():
    assert not read([np.zeros((4, 4), np.uint8)])[0][0].any()
    assert read([np.full((4, 4), 7, np.uint8)])[0][0].all()
    masks, encoding = read([np.random.default_rng(0).integers(0, 4, (9, 9), np.uint8)], lossy=True)
    assert not masks[0].any() and "all blank" in encoding.doubts[0]


def test_photos_are_refused(photo):
    with pytest.raises(InputError, match="these look like colour images: segment them first"):
        read([photo, photo[::-1]])
    with pytest.raises(InputError, match="these look like images of many shades"):
        read([photo[..., 0], photo[..., 1]])


def test_a_border_that_is_half_bright_is_a_doubt(figures):
    half = np.zeros((40, 40), np.uint8)
    half[:, :20] = 255
    _, encoding = read([half])
    assert "half bright, half dark" in encoding.doubts[0]


def test_what_overshoots_by_interpolation_is_no_score(large):
    soft = [
        cv2.resize(mask.astype(np.float32), (60, 72), interpolation=cv2.INTER_CUBIC)
        for mask in large
    ]
    assert min(picture.min() for picture in soft) < 0
    masks, encoding = read([picture - 0.01 for picture in soft])
    assert (
        overlap(masks, [picture > 0.51 for picture in soft]) == 1 and "score" not in encoding.words
    )


@pytest.mark.parametrize(("value", "said"), [(127, "to shadows"), (0.4, "above 0.5")])
def test_what_may_be_no_person_is_a_doubt(large, value, said):
    pictures = [mask * np.uint8(value) for mask in large]
    if value < 1:
        pictures = [cv2.GaussianBlur(value * mask.astype(np.float32), (0, 0), 2) for mask in large]
    masks, encoding = read(pictures)
    assert said in encoding.doubts[0] and masks[0].any()

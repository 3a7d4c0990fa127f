import io
import struct
import sys
import zlib

import cv2
import numpy as np
import pytest
from PIL import Image, UnidentifiedImageError

from silpose.core.errors import InputError
from silpose.silhouette.masks.image_files import read_image_file, read_photograph


def images(figures):
    return [Image.fromarray(255 * mask) for mask in figures]


@pytest.mark.parametrize("suffix", [".png", ".jpg", ".webp"])
@pytest.mark.parametrize("part", [0.3, 0.8])
def test_a_truncated_file_is_named(tmp_path, figures, suffix, part):
    file = tmp_path / f"mask{suffix}"
    images(figures)[0].resize((200, 240)).save(file)
    whole = file.read_bytes()
    file.write_bytes(whole[: int(part * len(whole))])
    with pytest.raises(InputError, match=rf"mask\{suffix}' is (incomplete or damaged|no image)"):
        read_image_file(file)


def test_empty_and_foreign_files_are_named(tmp_path):
    file = tmp_path / "mask.png"
    file.write_bytes(b"")
    with pytest.raises(InputError, match=r"mask\.png' is empty"):
        read_image_file(file)
    file.write_text("<html>")
    with pytest.raises(InputError, match=r"mask\.png' is no image"):
        read_image_file(file)


@pytest.mark.parametrize("suffix", [".png", ".webp"])
def test_frames_that_were_joined_since_they_are_equal_are_repeated(tmp_path, figures, suffix):
    file = tmp_path / f"masks{suffix}"
    first, second, third, *_ = images(figures)
    frames = [first, first, second, second, second, third]
    first.save(file, save_all=True, append_images=frames[1:], duration=40, lossless=True)
    read = read_image_file(file)
    assert len(read.pictures) == 6
    assert read.frames_per_second == pytest.approx(25)
    for picture, frame in zip(read.pictures, frames, strict=True):
        np.testing.assert_array_equal(picture.pixels, np.asarray(frame))


@pytest.mark.parametrize("suffix", [".png", ".jpg"])
def test_common_kinds_are_decoded_fast(tmp_path, figures, monkeypatch, suffix):
    monkeypatch.setattr(sys.modules[read_image_file.__module__], "_read_with_pillow", pytest.fail)
    masks = images(figures)
    for image in (masks[0], Image.merge("RGB", masks[:3])):
        image.save(tmp_path / f"mask{suffix}", quality=100, subsampling=0)
        (picture,) = read_image_file(tmp_path / f"mask{suffix}").pictures
        np.testing.assert_array_equal(picture.pixels > 127, np.asarray(image) > 127)


def test_what_opencv_cannot_decode_is_named(tmp_path, figures):
    images(figures)[0].save(tmp_path / "mask.png")
    whole = (tmp_path / "mask.png").read_bytes()
    at = whole.index(b"IDAT") + 4
    (tmp_path / "mask.png").write_bytes(whole[:at] + b"\0\0\0\0" + whole[at + 4 :])
    with pytest.raises(InputError, match="damaged"):
        read_image_file(tmp_path / "mask.png")


def test_frames_of_uneven_times_are_not_repeated(tmp_path, figures):
    first, *others = images(figures)[:3]
    first.save(tmp_path / "a.png", save_all=True, append_images=others, duration=[40, 100, 40])
    assert len(read_image_file(tmp_path / "a.png").pictures) == 3


def test_a_single_page_has_its_files_name(tmp_path, monkeypatch):
    def unknown(*_):
        raise UnidentifiedImageError

    monkeypatch.setattr(sys.modules[read_image_file.__module__], "_opened", unknown)
    cv2.imwrite(str(tmp_path / "a.tif"), np.full((8, 6, 3), 65535, np.uint16))
    assert [p.name for p in read_image_file(tmp_path / "a.tif").pictures] == ["a.tif"]


def test_pages_have_no_rate(tmp_path, figures):
    first, *others = [Image.fromarray(65535 * mask.astype(np.uint16)) for mask in figures]
    first.save(tmp_path / "masks.tif", save_all=True, append_images=others)
    read = read_image_file(tmp_path / "masks.tif")
    assert [picture.pixels.dtype for picture in read.pictures] == [np.uint16] * 6
    assert read.frames_per_second is None
    assert read.pictures[2].name == "masks.tif 2"


def test_a_palette_keeps_its_indices(tmp_path, figures):
    labels = Image.fromarray(figures[0]).convert("P")
    labels.putdata(figures[0].ravel().tolist())
    labels.putpalette([0, 0, 0, 128, 0, 0])
    labels.save(tmp_path / "labels.png")
    (picture,) = read_image_file(tmp_path / "labels.png").pictures
    np.testing.assert_array_equal(picture.pixels, figures[0])
    np.testing.assert_array_equal(picture.palette[:2], [[0, 0, 0], [128, 0, 0]])


def test_a_palette_with_transparency_has_alpha(tmp_path, figures):
    cut_out = np.dstack([np.full((*figures[0].shape, 3), 90, np.uint8), 255 * figures[0]])
    Image.fromarray(cut_out).quantize(8).save(tmp_path / "small.png")
    (picture,) = read_image_file(tmp_path / "small.png").pictures
    np.testing.assert_array_equal(picture.alpha, 255 * figures[0])


def test_the_picture_for_programs_without_animations_is_left_out(tmp_path, figures):
    first, *others = images(figures)
    cover = Image.new("L", first.size, 128)
    file = tmp_path / "masks.png"
    cover.save(file, save_all=True, append_images=[first, *others], default_image=True)
    assert len(read_image_file(file).pictures) == len(figures)


def chunk(kind, content, claimed=None):
    length = len(content) if claimed is None else claimed
    return (
        struct.pack(">I", length) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
    )


def png(width, height, claimed=None):
    """A PNG of a few bytes that claims a size, and a length of its pixels."""
    header = chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0))
    pixels = chunk(b"IDAT", zlib.compress(bytes(width)), claimed)
    return b"\x89PNG\r\n\x1a\n" + header + pixels + chunk(b"IEND", b"")


def jpeg(width, height):
    stored = io.BytesIO()
    Image.new("L", (16, 16)).save(stored, "JPEG")
    content = bytearray(stored.getvalue())
    place = content.index(b"\xff\xc0") + 5
    content[place : place + 4] = struct.pack(">HH", height, width)
    return bytes(content)


@pytest.mark.parametrize(
    "content",
    [
        png(100_000, 100_000), png(30_000, 30_000), png(4_000, 4_000),
        png(16, 16, claimed=2_000_000_000), jpeg(30_000, 30_000), jpeg(12_000, 12_000),
    ],
    ids=["100000", "30000", "more than its bytes hold", "a chunk of 2 GB", "JPEG", "small JPEG"],
)  # fmt: skip
def test_a_claimed_size_is_refused_before_memory_is_taken(tmp_path, monkeypatch, content):
    monkeypatch.setattr(cv2, "imdecode", lambda *_: pytest.fail("OpenCV would take the memory"))
    (tmp_path / "odd.png").write_bytes(content)
    with pytest.raises(InputError, match=r"odd\.png' is incomplete or damaged"):
        read_image_file(tmp_path / "odd.png")
    with pytest.raises(InputError, match=r"odd\.png' is (incomplete|no picture)"):
        read_photograph(tmp_path / "odd.png")


@pytest.mark.parametrize("kind", ["JPEG", "PNG"])
def test_a_photograph_that_was_cut_off_is_refused(tmp_path, kind):
    noise = np.random.default_rng(0).integers(0, 256, (60, 80, 3), np.uint8)
    Image.fromarray(noise).save(tmp_path / "a", kind)
    assert read_photograph(tmp_path / "a").shape == (60, 80, 3)
    (tmp_path / "a").write_bytes((tmp_path / "a").read_bytes()[:-3000])
    with pytest.raises(InputError, match="a' is incomplete or damaged"):
        read_photograph(tmp_path / "a")

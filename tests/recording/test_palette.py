import ast
import itertools
import re
from pathlib import Path

import numpy as np
import pytest
from colour_blindness import SEEN

from silpose.recording import palette
from silpose.tracking import STATES

XYZ = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])
HUES = (palette.TRUE, palette.ESTIMATED, *palette.MODES)
ROOT = Path(__file__).parents[2]
COLOURED = r"blue|red|orange|amber|yellow|green|cyan|purple|magenta|vermilion|sky|pink|violet|grey"
DARK, WHITE = (13, 16, 17), (255, 255, 255)  # of the viewer's themes


def linear(colours):
    values = np.asarray(colours) / 255
    return np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4)


def lab(light):
    white = XYZ.sum(axis=1)
    x, y, z = (np.cbrt(np.clip(light, 0, 1) @ XYZ.T / white)).T
    return np.stack([116 * y - 16, 500 * (x - y), 200 * (y - z)], axis=1)


def contrast(colour, other):
    low, high = sorted(float(linear(c) @ XYZ[1]) + 0.05 for c in (colour, other))
    return high / low


@pytest.mark.parametrize("kind", SEEN)
def test_hues_are_told_apart_with_any_colour_blindness(kind):
    places = lab(linear(HUES) @ np.transpose(SEEN[kind]))
    apart = [np.linalg.norm(a - b) for a, b in itertools.combinations(places, 2)]
    assert min(apart) > 15


@pytest.mark.parametrize("kind", SEEN)
@pytest.mark.parametrize(
    "table",
    [
        palette.STATES,
        palette.FIT_STATES,
        palette.SEEN,
        palette.ESTIMATE_STATES,
        palette.MASK_STATES,
        {name: palette.METHODS[name] for name in ("mean_pose", "nearest", "ridge", "oracle")},
    ],
)
def test_states_are_told_apart_with_any_colour_blindness(kind, table):
    places = lab(linear(list(table.values())) @ np.transpose(SEEN[kind]))
    assert min(np.linalg.norm(a - b) for a, b in itertools.combinations(places, 2)) > 15


@pytest.mark.parametrize("background", [DARK, WHITE])
def test_hues_are_seen_in_the_light_and_in_the_dark(background):
    assert min(contrast(colour, background) for colour in HUES[:4]) > 2.9
    sides = [palette.shade(colour, side) for colour in HUES for side in ("left", "right")]
    assert min(contrast(colour, background) for colour in (*HUES, *sides)) > 1.5


def test_the_left_side_is_light_and_the_right_side_dark():
    for colour in HUES:
        left, middle, right = lab(linear([palette.shade(colour, s) for s in ("left", "", "right")]))
        assert left[0] - 5 > middle[0] > right[0] + 5
        assert palette.shade(colour, "head") == colour


def test_neighbours_have_neighbouring_colours():
    colours = np.array([palette.hue(k, 100) for k in range(100)])
    steps = np.abs(np.diff(np.vstack([colours, colours[:1]]), axis=0)).max(axis=1)
    assert steps.min() > 0
    assert steps.max() < 20


def test_few_things_have_the_hues_of_modes_and_many_those_of_the_wheel():
    assert [palette.one_of(k, 4) for k in range(4)] == list(palette.MODES)
    assert len({palette.one_of(k, 9) for k in range(9)}) == 9
    assert palette.of_method("tracker", 0, 2) == palette.ESTIMATED
    assert palette.of_method("another", 1, 2) == palette.MODES[1]


def test_matplotlib_gets_six_digits():
    assert palette.hexed((0, 9, 255)) == "#0009ff"
    assert all(re.fullmatch("#[0-9a-f]{6}", palette.hexed(colour)) for colour in HUES)


def test_every_state_of_a_tracker_has_a_colour():
    assert set(palette.STATES) == set(STATES)
    assert palette.states(["lost"]) == palette.STATES
    assert {"poor", "lost"} <= set(palette.states(["poor", "lost"]))


def test_graded_colours_go_from_light_to_dark():
    brightness = [sum(palette.graded(palette.ESTIMATED, k, 5)) for k in range(5)]
    assert brightness == sorted(brightness, reverse=True)
    assert min(-np.diff(brightness)) > 40  # so that two that are next to each other are told apart


@pytest.mark.parametrize("package", ["experiments", "recording"])
def test_titles_and_captions_take_words_for_colours_from_the_palette(package):
    found = []
    for file in sorted((ROOT / "silpose" / package).rglob("*.py")):
        nodes = list(ast.walk(ast.parse(file.read_text())))
        alone = {id(node.value) for node in nodes if isinstance(node, ast.Expr)}  # docstrings
        found += [
            (file.name, node.value)
            for node in nodes
            if isinstance(node, ast.Constant) and isinstance(node.value, str)
            and id(node) not in alone and file.name != "palette.py"
            and re.search(rf"\b({COLOURED})\b", node.value, re.IGNORECASE)
        ]  # fmt: skip
    assert not found


@pytest.mark.parametrize("folder", [".", "notebooks", "docs", "docs/guides"])
def test_documents_name_colours_as_the_palette_does(folder):
    files = [*(ROOT / folder).glob("*.md"), *(ROOT / folder).glob("*.py")]
    words = {w.lower() for f in files for w in re.findall(rf"\b({COLOURED})\b", f.read_text())}
    assert words <= {word for name in palette.NAMES.values() for word in name.split()}


def test_no_word_stands_for_two_hues():
    assert len({palette.NAMES[colour] for colour in HUES}) == len(HUES)
    assert palette.NAMES[palette.EDGE] == "amber"  # not what people call vermilion

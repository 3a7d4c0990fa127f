from silpose.recording import entity_paths, palette
from silpose.recording.layout import video_layout
from silpose.recording.video_styles import log_video_styles


def names_of(part):
    inner = [name for each in getattr(part, "contents", ()) for name in names_of(each)]
    return [*inner, part.name] if hasattr(part, "origin") else inner


class Logged(dict):
    def log(self, entity, style, static):
        self[entity] = style


def test_titles_name_the_colours_that_are_drawn():
    said = names_of(video_layout(15.0, (96, 96)).root_container)
    overlay = next(name for name in said if "outline" in name)
    drawn = palette.EDGE, palette.ESTIMATED, palette.DOUBTFUL
    assert [palette.NAMES[colour] in overlay for colour in drawn] == [True] * 3
    assert any(name == "overlap (vermilion), confidence (grey)" for name in said)


def test_sides_of_a_gait_differ_in_lightness_alone():
    logged = Logged()
    log_video_styles(logged, (96, 96))
    colours = [
        logged[entity_paths.below(entity_paths.GAIT_PHASE, side)].colors.as_arrow_array()
        for side in ("left", "right")
    ]
    wanted = [palette.shade(palette.ESTIMATED, side) for side in ("left", "right")]
    rgb = [divmod(own[0].as_py() >> 8, 1 << 16) for own in colours]
    assert [(r, *divmod(rest, 256)) for r, rest in rgb] == wanted

import pytest
from hydra.core.override_parser.overrides_parser import OverridesParser
from hypothesis import example, given
from hypothesis import strategies as st
from omegaconf import OmegaConf

from silpose.app.config import load, plain
from silpose.app.typed_paths import quoted, with_paths_quoted

ODD = "\\'\"${}[](),=:+~?*-#@! \t\n%&|<>é日"
paths = st.text(
    st.one_of(st.sampled_from(ODD), st.characters(codec="utf-8", exclude_categories=["Cs"])),
    min_size=1,
)


@given(paths)
@example("a=b, [c] '${seed}' \\")
def test_any_path_goes_through_hydra_untouched(path):
    (override,) = OverridesParser.create().parse_overrides([f"source={quoted(path)}"])
    settings = OmegaConf.create({"source": None, "seed": 3})
    settings.source = override.value()
    assert OmegaConf.to_container(settings, resolve=True)["source"] == path


@pytest.mark.parametrize(
    "path", ["my masks (1)", "a,b", "[1,2]", "it's", "C:\\x\\", "1", "007", "ü=ö", "{a: b}", "~/x"]
)
def test_a_path_is_read_as_it_was_typed(path):
    settings = plain(load(["silhouette=masks", f"silhouette.source={path}"]))
    assert settings["silhouette"]["source"] == path
    assert plain(load(["experiment=predict", f"model={path}"]))["model"] == path


@pytest.mark.parametrize("ready", ["model='a b'", 'model="a b"', "model=null", "seed=a b", "model"])
def test_what_is_quoted_or_no_path_stays(ready):
    assert with_paths_quoted([ready]) == [ready]


def test_in_a_sweep_commas_separate_paths():
    assert with_paths_quoted(["model=a,b"], sweep=True) == ["model=a,b"]
    assert with_paths_quoted(["model=a (1)"], sweep=True) == ["model='a (1)'"]

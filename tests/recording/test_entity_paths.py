import re
from pathlib import Path

import pytest
from rerun.chunk import RrdReader

from silpose.recording import entity_paths as entities

# Below each of them an entity per method, body part, tracker or mode.
PER_SOMETHING = (
    entities.ERROR,
    entities.RETAINED_POINTS,
    entities.TRACKS,
    entities.KERNELS,
    entities.MODES,
    entities.HYPOTHESES,
    entities.OVERLAP_SHARES,
    entities.FITTED_BODY,
    entities.LEG_ANGLES,
    entities.GAIT_PHASE,
)
ENTITIES = {v for k, v in vars(entities).items() if k.isupper()} - {
    entities.INFLUENTIAL_EXAMPLES,  # these two only hold others
    entities.CONTEXT_SPACE,
}
PACKAGES = (
    *("motion", "silhouette", "dataset", "descriptor", "regression", "tracking", "fitting"),
    *("evaluation", "run"),
)


def entities_of(recording):
    """Entities of a recording, those that stand for many by the one above them."""
    found = {chunk.entity_path for chunk in RrdReader(recording).stream()}
    found = {path for path in found if not path.startswith("/__") and path != "/"}
    return {
        next((above for above in PER_SOMETHING if path.startswith(f"{above}/")), path)
        for path in found
    }


@pytest.mark.parametrize("entity", sorted(ENTITIES))
def test_a_path_begins_with_the_package_that_its_data_come_from(entity):
    assert entity.split("/")[1] in PACKAGES


def test_recordings_hold_every_entity_and_no_other(recordings):
    assert set().union(*map(entities_of, recordings.values())) == ENTITIES


def test_names_of_several_words_make_plain_paths(recordings):
    found = {c.entity_path for path in recordings.values() for c in RrdReader(path).stream()}
    assert entities.below(entities.ERROR, "best of 2") == f"{entities.ERROR}/best_of_2"
    assert f"{entities.ERROR}/best_of_2" in found
    assert not [path for path in found if "\\" in path or " " in path]


def test_the_documented_entities_are_those_that_there_are():
    page = (Path(__file__).parents[2] / "recordings" / "README.md").read_text()
    assert {path.split("/<")[0] for path in re.findall(r"`(/[^`]+)`", page)} == ENTITIES

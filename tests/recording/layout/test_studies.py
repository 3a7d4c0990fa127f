import rerun.blueprint as rrb

from silpose.recording import entity_paths as entities
from silpose.recording.layout import study_layout


def _origins(part):
    if isinstance(part, rrb.View):
        return [part.origin]
    return [origin for inner in part.contents for origin in _origins(inner)]


def test_a_tall_figure_stands_beside_its_errors_from_top_to_bottom():
    figure, beside = study_layout("errors", 15.0, masks=True, wide=False).root_container.contents
    assert figure.origin == entities.FIGURE
    assert entities.METRICS in _origins(beside) and entities.CAMERA in _origins(beside)
    shown, texts = study_layout("errors", 15.0, masks=True).root_container.contents
    assert _origins(shown)[:2] == [entities.FIGURE, entities.CAMERA]
    assert entities.METRICS in _origins(texts)

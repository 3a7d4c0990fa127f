import yaml

from silpose.recording.runs.model_settings import with_model_settings

OWN = """
experiment: predict
show: rvm
descriptor: {codebook_size: 100}
silhouette: {source: masks, person: left, camera: {width: 256}}
"""


def test_the_settings_of_training_are_those_of_the_model(tmp_path):
    (tmp_path / "config.yaml").write_text(
        "experiment: tracking\nshow: ridge\ndescriptor: {codebook_size: 40}\nseed: 3\n"
        "silhouette: {source: other, camera: {width: 88}, body: {level: 2}}\n"
    )
    for model in (tmp_path, tmp_path / "model.npz"):
        merged = yaml.safe_load(with_model_settings(OWN, model))
        assert merged == {
            "experiment": "predict",
            "show": "ridge",
            "descriptor": {"codebook_size": 40},
            "silhouette": {
                "source": "masks", "person": "left", "camera": {"width": 88}, "body": {"level": 2},
            },
        }  # fmt: skip


def test_where_they_are_not_known_there_are_none(tmp_path):
    merged = yaml.safe_load(with_model_settings(OWN, tmp_path / "model.npz"))
    assert merged == {
        "experiment": "predict", "silhouette": {"source": "masks", "person": "left"},
    }  # fmt: skip

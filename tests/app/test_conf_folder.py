from silpose.app.conf_folder import config_folder, groups


def test_groups_are_the_folders_and_choices_the_files():
    assert "scenes" not in groups()["silhouette"]
    assert groups()["silhouette/scenes"] == ("bodies", "casia_b", "one", "wide")
    root = config_folder()
    files = {file.relative_to(root).as_posix() for file in root.rglob("*.yaml")}
    named = {f"{group}/{choice}.yaml" for group, names in groups().items() for choice in names}
    assert files == named | {"config.yaml"}

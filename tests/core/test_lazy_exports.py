import sys

import pytest

from silpose.core.lazy_exports import lazy_exports


def test_a_module_is_imported_when_its_name_is_used(tmp_path, monkeypatch):
    (tmp_path / "lazy_example").mkdir()
    (tmp_path / "lazy_example" / "__init__.py").touch()
    (tmp_path / "lazy_example" / "heavy.py").write_text("value = 3\n")
    monkeypatch.syspath_prepend(tmp_path)
    get = lazy_exports("lazy_example", {"heavy": ("value",)})
    assert "lazy_example.heavy" not in sys.modules
    assert get("value") == 3
    assert "lazy_example.heavy" in sys.modules


def test_an_unknown_name_is_no_attribute():
    with pytest.raises(AttributeError, match="module 'silpose' has no attribute 'foo'"):
        lazy_exports("silpose", {"core.errors": ("InputError",)})("foo")

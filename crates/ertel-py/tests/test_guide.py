"""The guide's snippets run, in their order, in one interpreter."""

from __future__ import annotations

import re
from pathlib import Path

import pytest


@pytest.mark.parametrize("name", ["docs/guide/python.md", "crates/ertel-py/README.md"])
def test_snippets(name: str, root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    if name.endswith("python.md"):
        for package in ("pandas", "matplotlib", "scipy", "SALib", "meshio"):
            pytest.importorskip(package)
    snippets = re.findall(r"```python\n(.*?)```", (root / name).read_text(encoding="utf-8"), re.DOTALL)
    assert snippets
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {"__name__": "guide"}
    for i, snippet in enumerate(snippets, 1):
        exec(compile(snippet, f"{name}, snippet {i}", "exec"), names)


def test_named_attributes_exist(root: Path) -> None:
    """What tables and sentences of the guide name is in the package."""
    import ertel
    import ertel.distributed

    text = (root / "docs/guide/python.md").read_text(encoding="utf-8")
    for owner, attribute in re.findall(r"`(ertel|result)\.(\w+)", text):
        target = ertel if owner == "ertel" else ertel.Result
        assert hasattr(target, attribute), f"{owner}.{attribute}"

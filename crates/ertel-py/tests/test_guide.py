"""The guide's snippets run, in their order, in one interpreter."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest


@pytest.mark.parametrize("name", ["docs/guide/python.md", "docs/guide/research.md", "crates/ertel-py/README.md"])
def test_snippets(name: str, root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    if not name.endswith("README.md"):
        for package in ("pandas", "matplotlib", "scipy", "SALib", "meshio"):
            pytest.importorskip(package)
    snippets = re.findall(r"```python\n(.*?)```", (root / name).read_text(encoding="utf-8"), re.DOTALL)
    assert snippets
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {"__name__": "guide"}
    for i, snippet in enumerate(snippets, 1):
        exec(compile(snippet, f"{name}, snippet {i}", "exec"), names)


def test_numbers_of_the_research_page(root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The films and bars in its comments and its table are those that its snippets compute."""
    for package in ("scipy", "meshio"):
        pytest.importorskip(package)
    text = (root / "docs/guide/research.md").read_text(encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {}
    for snippet in re.findall(r"```python\n(.*?)```", text, re.DOTALL):
        exec(compile(snippet, "research.md", "exec"), names)
    shown = re.findall(r"# ([\d.]+) ± ([\d.]+) nm", text)
    films = [result.film_central for result in names["results"].values()]
    assert len(shown) == 2
    for (value, bar), film in zip(shown, films):
        assert float(value) == pytest.approx(film.value * 1e9, abs=0.3 * film.error * 1e9) and float(bar) == pytest.approx(film.error * 1e9, rel=0.15)
    assert names["films"] == pytest.approx([237.59e-9, 237.59e-9], abs=0.005e-9) and "# 237.59 nm by both" in text
    rows = re.findall(r"^\| ([\d.]+) \| (\d+) \| ([\d.]+) \| ([\d.]+) \| −([\d.]+) \|$", text, re.MULTILINE)
    assert [float(row[0]) for row in rows] == list(names["meshes"])
    for (_, unknowns, value, bar, off), result in zip(rows, names["meshes"].values()):
        film = result.film_central
        assert int(unknowns) == result.to_dict()["stats"]["levels"][-1]["n_pressure_dofs"]
        assert (float(value), float(bar)) == pytest.approx((film.value * 1e9, film.error * 1e9), rel=0.02)
        assert float(off) == pytest.approx((names["best"] - film.value) * 1e9, abs=0.006)


def test_named_attributes_exist(root: Path) -> None:
    """Names in tables and sentences of the guide exist in the package."""
    import ertel
    import ertel.distributed

    text = (root / "docs/guide/python.md").read_text(encoding="utf-8")
    for owner, attribute in re.findall(r"`(ertel|result)\.(\w+)", text):
        target = ertel if owner == "ertel" else ertel.Result
        assert hasattr(target, attribute), f"{owner}.{attribute}"

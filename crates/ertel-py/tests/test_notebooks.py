"""Every notebook runs from its first to its last cell, and is kept with the outputs of such a run."""

from __future__ import annotations

import base64
import sys
from pathlib import Path
from typing import Any

import pytest

nbformat = pytest.importorskip("nbformat")
pytest.importorskip("nbclient")

FOLDER = Path(__file__).parent.parent / "notebooks"
NOTEBOOKS = sorted(FOLDER.glob("*.ipynb"))
MOST_OF_A_PICTURE = 100_000
MOST_OF_A_NOTEBOOK = 400_000


def kinds(notebook: Any) -> list[list[str]]:
    """Outputs of each cell: streams, errors, and the formats of data."""
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    return [[",".join(sorted(output.get("data", {"name": ""}))) for output in cell.outputs] for cell in cells]


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The kept outputs are of the kept cells, and a new run gives the same kinds of output."""
    monkeypatch.syspath_prepend(str(FOLDER))
    monkeypatch.setenv("ERTEL_CASES", "")
    import run

    kept = nbformat.read(path, as_version=4)
    assert kept.metadata.get("ertel", {}).get("cells") == run.mark(kept), f"the cells are not those that ran: {sys.executable} {FOLDER}/run.py"
    assert kinds(run.run(path)) == kinds(kept)


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_outputs_are_kept_and_small(path: Path) -> None:
    kept = nbformat.read(path, as_version=4)
    cells = [cell for cell in kept.cells if cell.cell_type == "code"]
    assert sum(bool(cell.outputs) for cell in cells) >= 2, "kept with outputs"
    assert [cell.execution_count for cell in cells] == list(range(1, len(cells) + 1)), "run from first to last"
    for cell in cells:
        if ".plot(" in cell.source.splitlines()[-1]:
            assert any("image/png" in output.get("data", {}) for output in cell.outputs), f"{cell.source}: no picture"
    text = path.read_text(encoding="utf-8")
    assert len(text) < MOST_OF_A_NOTEBOOK
    assert not any(f"{place}/" in text for place in ("/tmp", "/home", "/root", "/work", str(FOLDER))), "a path of the machine that ran it"
    # Results of a tutorial are plausible: no films that friction would burn, no traction that no lubricant has.
    assert "friction heats the film by" not in text and "larger than measured for any lubricant" not in text
    for output in (output for cell in cells for output in cell.outputs):
        assert output.output_type != "error"
        assert output.get("name") != "stderr", output.get("text")
        for kind, data in output.get("data", {}).items():
            assert kind.startswith("text/") or len(base64.b64decode(data)) < MOST_OF_A_PICTURE


def test_they_are_seven_and_the_guide_shows_them(root: Path) -> None:
    assert len(NOTEBOOKS) == 7
    guide = (root / "docs/guide/python.md").read_text(encoding="utf-8")
    for path in NOTEBOOKS:
        assert f"(../../crates/ertel-py/notebooks/{path.name})" in guide, path.name

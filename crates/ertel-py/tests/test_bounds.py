"""Arguments that no study and no contact can have."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import ertel


@pytest.mark.parametrize("name", ["jobs", "threads"])
def test_no_threads(name: str, cases: Path, tmp_path: Path) -> None:
    with pytest.raises(ertel.CaseError, match=f"{name} = 0"):
        ertel.sweep(cases / "speeds-and-loads.toml", tmp_path / "out", **{name: 0})
    assert not (tmp_path / "out").exists()


def test_a_film_too_thin_for_any_mesh_is_bad_input(line: dict[str, Any]) -> None:
    """As for the program, exit code 2, which tells what to change."""
    line["motion"]["entrainment_speed"] = "1e-9 m/s"
    with pytest.raises(ertel.CaseError, match="too thin") as error:
        ertel.Case(**line).solve()
    assert "help:" in str(error.value)

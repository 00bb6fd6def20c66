"""Arguments that no study and no contact can have."""

from __future__ import annotations

from pathlib import Path

import pytest

import ertel


@pytest.mark.parametrize("name", ["jobs", "threads"])
def test_no_threads(name: str, cases: Path, tmp_path: Path) -> None:
    with pytest.raises(ertel.CaseError, match=f"{name} = 0"):
        ertel.sweep(cases / "speeds-and-loads.toml", tmp_path / "out", **{name: 0})
    assert not (tmp_path / "out").exists()


def test_a_film_too_thin_for_any_mesh_is_bad_input(root: Path) -> None:
    """As for the program, exit code 2, which tells what to change."""
    case = ertel.Case.from_file(root / "crates/ertel-cli/tests/bad/film-too-thin.toml")
    with pytest.raises(ertel.CaseError, match="the film is too thin to resolve") as error:
        case.solve()
    assert "= help: " in str(error.value)


BAD = sorted((Path(__file__).resolve().parents[2] / "ertel-cli/tests/bad").glob("*.toml"))


@pytest.mark.parametrize("path", [p for p in BAD if "film-too-thin" not in p.stem], ids=lambda path: path.stem)
def test_what_the_program_refuses_is_a_case_error(path: Path) -> None:
    with pytest.raises(ertel.CaseError, match=path.name):
        ertel.Case.from_file(path)

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
    """As exit code 2 of the program, with advice on what to change."""
    case = ertel.Case.from_file(root / "crates/ertel-cli/tests/bad/film-too-thin.toml")
    with pytest.raises(ertel.CaseError, match="the film is too thin to resolve") as error:
        case.solve()
    assert "= help: " in str(error.value)


FOLDER = Path(__file__).resolve().parents[2] / "ertel-cli/tests/bad"


def bad_cases() -> dict[str, str]:
    """Names and texts of the cases that the program must refuse: files, and the base case of `cases.txt` with its changes."""
    cases = {path.stem: path.read_text(encoding="utf-8") for path in FOLDER.glob("*.toml")}
    base, *others = (FOLDER / "cases.txt").read_text(encoding="utf-8").split("\n== ")[1:]
    for name, *changes in (other.splitlines() for other in others):
        lines = [line for line in base.splitlines()[1:] if line]
        at = len(lines)
        for mark, text in ((change[:2], change[2:]) for change in changes):
            if mark == "- ":
                at = lines.index(text)
                del lines[at]
            elif mark == "@ ":
                at = lines.index(text) + 1
            elif mark == "+ ":
                lines.insert(at, text)
                at += 1
        cases[name] = "\n".join(lines) + "\n"
    return cases


BAD = sorted((name, text) for name, text in bad_cases().items() if "film-too-thin" not in name)


@pytest.mark.parametrize(("name", "text"), BAD, ids=[name for name, _ in BAD])
def test_what_the_program_refuses_is_a_case_error(name: str, text: str, tmp_path: Path) -> None:
    path = tmp_path / f"{name}.toml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(ertel.CaseError, match=path.name):
        ertel.Case.from_file(path)

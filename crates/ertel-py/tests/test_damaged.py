"""`ertel.read` as a whole on damaged folders: whatever stands there, the errors are the promised ones."""

from __future__ import annotations

import random
import shutil
from pathlib import Path
from typing import Any

import pytest

import ertel

# Damaged copies of each folder; ERTEL's own fuzz command damages what the program reads.
N_COPIES = 150
PIECES = [b"", b"\0", b"\xff", b"\x1b", b'"', b"nan", b"-1", b"1e999", b"null", b"{}", b"[]", b"\n", b",", b"</", b"99999999999999999999"]


def _damage(content: bytes, rng: random.Random) -> bytes:
    """Cut off, a piece put in or over another, a stretch doubled or taken out."""
    start = rng.randrange(len(content) + 1)
    end = min(len(content), start + rng.choice([0, 1, 3, 30]))
    match rng.randrange(5):
        case 0:
            return content[:start]
        case 1:
            return content[:start] + content[end:]
        case 2:
            return content[:end] + content[start:]
        case _:
            return content[:start] + rng.choice(PIECES) + content[end:]


def _look(folder: Path) -> None:
    """All that a result has of its folder."""
    found: Any = ertel.read(folder)
    for name in ("case", "report", "warnings", "table", "points", "centreline", "outputs", "statistics", "figures"):
        value = getattr(found, name, None)
        if name == "outputs" and value:
            value[0].film
    for name in getattr(found, "field_names", []):
        found.field(name)
    if hasattr(found, "to_pandas"):
        found.to_pandas()
    repr(found), found.to_dict() if hasattr(found, "to_dict") else None


@pytest.fixture(scope="module")
def folders(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    from conftest import LINE

    place = tmp_path_factory.mktemp("damaged")
    line: dict[str, Any] = {key: dict(value) for key, value in LINE.items()}
    curve = {**line, "curve": {"quantity": "motion.entrainment_speed", "values": ["1 m/s", "2 m/s"]}}
    course = {"course": "ramp", "end": "0.1 ms", "to": "110 kN/m"}
    in_time = {**line, "transient": {"duration": "0.1 ms", "load": course}}
    made = []
    for name, keys in {"result": line, "curve": curve, "transient": in_time}.items():
        made.append(ertel.Case(**keys).solve().save(place / name))
    (place / "base.toml").write_text(ertel.Case(**line).text)
    axis = [{"key": "contact.load", "values": ["90 kN/m", "100 kN/m"]}]
    ertel.sweep({"case": str(place / "base.toml"), "axis": axis}, place / "study", jobs=1)
    return [*made, place / "study"]


def test_damaged_folders_give_the_promised_errors(folders: list[Path], tmp_path: Path) -> None:
    pytest.importorskip("pandas")
    rng = random.Random(59)
    refused = 0
    for folder in folders:
        for i in range(N_COPIES):
            copy = tmp_path / "copy"
            shutil.copytree(folder, copy)
            file = rng.choice([path for path in sorted(copy.rglob("*")) if path.is_file()])
            content = file.read_bytes()
            for _ in range(rng.choice([1, 1, 2, 5])):
                content = _damage(content, rng)
            file.write_bytes(content)
            try:
                _look(copy)
            except (ertel.OutputError, ertel.CaseError):
                refused += 1
            except Exception as error:
                raise AssertionError(f"copy {i} of {folder.name}, {file.name}: {type(error).__name__}: {error}") from error
            shutil.rmtree(copy)
    assert refused > len(folders) * N_COPIES / 10

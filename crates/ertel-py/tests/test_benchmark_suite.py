"""The script of the benchmark suite."""

import csv
import os
import subprocess
import sys
from pathlib import Path

import pytest

SUITE = Path(__file__).parents[3] / "benchmark-suite"
sys.path.insert(0, str(SUITE))

import benchmark  # noqa: E402


def compared(folder: Path, rows: list[tuple[str, str, object]]) -> subprocess.CompletedProcess[str]:
    results = folder / "mine.csv"
    with results.open("w", newline="") as file:
        out = csv.writer(file)
        out.writerow(["case", "figure", "value"])
        out.writerows(rows)
    command = [sys.executable, str(SUITE / "benchmark.py"), "compare", str(results)]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def test_results_are_compared(tmp_path: Path) -> None:
    with (SUITE / "values.csv").open(newline="") as file:
        values = [(row["case"], row["figure"], float(row["volumes"])) for row in csv.DictReader(file)]
    assert {case for case, _, _ in values} == set(benchmark.cases())
    same = compared(tmp_path, values)
    assert same.returncode == 0, same.stdout + same.stderr
    assert f"{len(values)} of {len(values)} figures compared, 0 outside the bars" in same.stdout
    case, figure, value = values[0]
    other = compared(tmp_path, [(case, figure, 1.1 * value)])
    assert other.returncode == 1
    assert "OUTSIDE" in other.stdout
    for row, words in [
        (("nothing", figure, value), "nothing"),
        ((case, figure, "thin"), "numbers"),
        ((case, figure, "nan"), "finite"),
    ]:
        refused = compared(tmp_path, [(case, values[1][1], values[1][2]), row])
        assert refused.returncode == 2
        assert "mine.csv:3: " in refused.stderr and words in refused.stderr, refused.stderr
    twice = compared(tmp_path, [(case, figure, value), (case, figure, value)])
    assert twice.returncode == 2 and "given twice" in twice.stderr


def test_ertel_solves_a_case(tmp_path: Path) -> None:
    found = benchmark.solve(os.environ["ERTEL"], "line", "finite-volumes")
    rows = [("line", figure, value) for figure, (value, _) in found.items()]
    assert len(rows) > 2
    assert compared(tmp_path, [row for row in rows if row[1] != "traction_coefficient"]).returncode == 0


@pytest.mark.parametrize("case", benchmark.cases())
def test_cases_are_listed(case: str) -> None:
    assert f"| `{case}` |" in (SUITE / "README.md").read_text(encoding="utf-8")

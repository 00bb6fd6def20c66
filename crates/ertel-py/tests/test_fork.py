"""Processes that are forked after a solve: the solver's threads are not copied with them."""

from __future__ import annotations

import multiprocessing
import subprocess
import sys

import pytest

CODE = """
import multiprocessing, pathlib, sys
import ertel

case = ertel.Case.from_text(pathlib.Path(sys.argv[1]).read_text())
alone = float(case.solve().film_central)

def film(speed):
    result = case.solve()
    assert result.pressure.max() > 1e8
    return float(result.film_central)

with multiprocessing.get_context("fork").Pool(2) as pool:
    assert pool.map(film, range(4)) == [alone] * 4
print("same")
"""


@pytest.mark.skipif("fork" not in multiprocessing.get_all_start_methods(), reason="no fork on this system")
def test_solves_in_forked_processes(root: object) -> None:
    # In a separate interpreter: a solve that hangs is stopped by the time limit.
    path = f"{root}/cases/roller.toml"
    run = subprocess.run([sys.executable, "-c", CODE, path], capture_output=True, text=True, timeout=60, check=False)
    assert run.returncode == 0 and run.stdout == "same\n", run.stderr

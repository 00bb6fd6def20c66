"""Where the shipped cases and the program are."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture(scope="session")
def root() -> Path:
    return ROOT


@pytest.fixture(scope="session")
def cases() -> Path:
    return ROOT / "cases"


@pytest.fixture(scope="session")
def program() -> str:
    """The program `ertel`, by the environment variable ERTEL."""
    path = os.environ.get("ERTEL")
    if path is None:
        pytest.skip("ERTEL does not name the program")
    return path


@pytest.fixture(scope="session")
def interrupted() -> Callable[[str, float], None]:
    """Runs lines that make a `case`, interrupts its solve, and checks that it ends within some seconds."""

    def run(lines: str, seconds: float) -> None:
        code = (
            f"import sys, ertel\n{lines}"
            "print('ready', flush=True)\n"
            "try:\n    case.solve()\n"
            "except KeyboardInterrupt:\n    print('interrupted'); sys.exit(7)\n"
        )
        process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
        assert process.stdout is not None and process.stdout.readline() == "ready\n"
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        begun = time.monotonic()
        assert process.communicate(timeout=60)[0] == "interrupted\n"
        assert process.returncode == 7 and time.monotonic() - begun < seconds

    return run


LINE = {
    "contact": {"kind": "line", "radius": "10 mm", "load": "100 kN/m"},
    "bodies": {"body_1": "steel", "body_2": "steel"},
    "motion": {"entrainment_speed": "2 m/s", "slide_to_roll_ratio": 0.0},
    "lubricant": {
        "temperature": "40 degC",
        "density": {"law": "dowson-higginson", "rho_0": "870 kg/m^3"},
        "viscosity": {"law": "roelands", "mu_0": "40 mPa.s", "alpha": "20 1/GPa"},
    },
    "mesh": {"target_error": "1 %"},
}


@pytest.fixture
def line() -> dict[str, object]:
    """Keywords of a line contact that is solved in hundredths of a second."""
    return {key: dict(value) for key, value in LINE.items()}

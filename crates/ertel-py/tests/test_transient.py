"""Cases in time: instants, profiles, folders."""

from __future__ import annotations

import pickle
from pathlib import Path

import numpy as np
import pytest

import ertel


@pytest.fixture(scope="module")
def case(cases: Path) -> ertel.Case:
    """A line contact whose load falls to a half."""
    text = (cases / "roller.toml").read_text()
    load = '[transient.load]\ncourse = "ramp"\nstart = "0.1 ms"\nend = "0.3 ms"\nto = "50 kN/m"\n'
    return ertel.Case.from_text(f'{text}\n[transient]\nduration = "0.5 ms"\noutput_times = ["0 ms", "0.3 ms"]\n{load}')


@pytest.fixture(scope="module")
def solved(case: ertel.Case) -> ertel.Transient:
    events: list[dict[str, object]] = []
    found = case.solve(progress=events.append)
    assert isinstance(found, ertel.Transient)
    # The steady start is none of the steps.
    assert sum(event["event"] == "instant" for event in events) == len(found)
    return found


def test_instants_follow_the_load(case: ertel.Case, solved: ertel.Transient) -> None:
    assert case.is_transient and solved.complete and solved.reason is None
    first, last = solved[0], solved[len(solved) - 1]
    assert first.time == 0 and last.time == pytest.approx(0.5e-3, rel=1e-12)
    assert last.load == pytest.approx(50e3, rel=1e-12)
    assert last.film_force == pytest.approx(last.load, rel=1e-3) and last.approach < 0 and solved.coefficient_of_restitution is None
    assert last.film_central.error is not None and 0 < last.film_central.error < 0.01 * last.film_central.value
    assert np.all(np.diff(solved.time) > 0)
    assert [profile["time"] for profile in solved.profiles] == pytest.approx([0, 0.3e-3])
    # Half the load has the pressure of its root in the middle.
    middle = [float(np.interp(0, profile["x"], profile["pressure"])) for profile in solved.profiles]
    assert middle[1] == pytest.approx(np.sqrt(0.5) * middle[0], rel=0.05)
    # The integral of the pressure is the load.
    profile = solved.profiles[1]
    carried = np.trapezoid(profile["pressure"], profile["x"]) if hasattr(np, "trapezoid") else np.trapz(profile["pressure"], profile["x"])
    assert carried == pytest.approx(50e3, rel=5e-3)
    with pytest.raises(KeyError, match="film_central"):
        first["film"]


def test_a_folder_opens_again(solved: ertel.Transient, tmp_path: Path) -> None:
    again = ertel.read(solved.save(tmp_path / "course"))
    assert isinstance(again, ertel.Transient)
    assert again.to_dict() == solved.to_dict() and again.table == solved.table and again.report == solved.report
    assert list(again.to_pandas().columns) == list(solved.to_pandas().columns)
    assert pickle.loads(pickle.dumps(solved)).series("film_central") == pytest.approx(solved.series("film_central"))
    (tmp_path / "course" / "transient.json").write_text('{"format": "ertel-transient"}')
    with pytest.raises(ertel.OutputError, match="format_version"):
        ertel.read(tmp_path / "course")


def test_start_and_studies_are_refused(case: ertel.Case) -> None:
    steady = ertel.Case.from_text(case.text[: case.text.index("[transient]")])
    result = steady.solve()
    assert isinstance(result, ertel.Result)
    with pytest.raises(ertel.CaseError, match="steady contact"):
        case.solve(start=result)

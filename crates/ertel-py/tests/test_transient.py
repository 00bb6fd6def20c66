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
    assert last.radius == first.radius == pytest.approx(0.01) and last.temperature == pytest.approx(313.15) and last.oil_layer is None
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


def test_output_times_have_fields(solved: ertel.Transient, tmp_path: Path) -> None:
    first, second = solved.outputs
    assert [first.time, second.time] == pytest.approx([0, 0.3e-3]) and solved[0].has_fields and not solved[1].has_fields
    assert second.film.shape == second.pressure.shape == second.x.shape and second.y == [0]
    profile = solved.profiles[1]
    assert np.interp(0, second.x, second.film) == pytest.approx(np.interp(0, profile["x"], profile["film_thickness"]), rel=1e-6)
    with pytest.raises(ertel.OutputError, match="output_times"):
        solved[1].film
    axes = solved.plot(0).axes
    assert len(axes) == 2 and axes[1].get_ylabel().startswith("pressure")
    # A folder has the centrelines, a pickle as well.
    again = ertel.read(solved.save(tmp_path / "fields"))
    assert isinstance(again, ertel.Transient)
    for other in (again, pickle.loads(pickle.dumps(solved))):
        assert other.outputs[1].pressure == pytest.approx(second.pressure, rel=1e-6)
    with pytest.raises(ertel.OutputError, match="result.nc"):
        again.to_netcdf(tmp_path / "no.nc")


def test_netcdf_and_animation(solved: ertel.Transient, tmp_path: Path) -> None:
    scipy_io = pytest.importorskip("scipy.io")
    with scipy_io.netcdf_file(solved.to_netcdf(tmp_path / "time.nc"), mmap=False) as file:
        variables = file.variables
        assert dict(file.dimensions) == {"time": len(solved), "output_time": 2, "x": len(solved[0].x)}
        assert variables["time"].data == pytest.approx(solved.time)
        film, error = variables["film_central"], variables["film_central_error"]
        assert film.data == pytest.approx(solved.series("film_central")) and film.units == b"m"
        assert error.data[0] == pytest.approx(solved[0].film_central.error)
        carried = variables["pressure"].data[1] @ np.gradient(variables["x"].data)
        assert carried == pytest.approx(50e3, rel=5e-3)
    content = solved.animate(tmp_path / "time.png").read_bytes()
    assert content.startswith(b"\x89PNG") and content.count(b"acTL") == 1 and content.count(b"fcTL") == 2


def test_a_point_contact_has_fields_across_the_motion(cases: Path, tmp_path: Path) -> None:
    text = (cases / "ball-on-disc.toml").read_text()
    extra = '\n[mesh]\ntarget_error = "10 %"\n[output]\nvtu = true\nanimation = true\nnetcdf = true\n[transient]\nduration = "20 us"\noutput_times = ["0 us", "20 us"]\n'
    solved = ertel.Case.from_text(text + extra).solve()
    assert isinstance(solved, ertel.Transient)
    last = solved.outputs[-1]
    assert last.film.shape == (len(last.y), len(last.x)) and last.film.size <= 12_000
    # Alike on both sides, thinnest off the centreline, and the pressure there carries most of the load.
    assert last.film == pytest.approx(last.film[::-1])
    row = np.unravel_index(np.argmin(last.film), last.film.shape)[0]
    assert row != len(last.y) // 2 and last.film.min() == pytest.approx(last.film_minimum.value, rel=0.1)
    carried = np.gradient(last.y) @ last.pressure @ np.gradient(last.x)
    assert carried == pytest.approx(last.load, rel=0.05)
    again = ertel.read(solved.save(tmp_path / "ball"))
    assert isinstance(again, ertel.Transient)
    assert again.outputs[-1].film == pytest.approx(last.film) and again.outputs[-1].y == pytest.approx(last.y)
    assert again.animate(tmp_path / "copy.png").read_bytes() == (tmp_path / "ball" / "animation.png").read_bytes()
    assert again.to_netcdf(tmp_path / "copy.nc").exists()
    assert again.plot(len(again) - 1).axes
    (tmp_path / "ball" / "fields.pvd").unlink()
    with pytest.raises(ertel.OutputError, match="vtu = true"):
        ertel.read(tmp_path / "ball").outputs[0].film


def test_start_and_studies_are_refused(case: ertel.Case) -> None:
    steady = ertel.Case.from_text(case.text[: case.text.index("[transient]")])
    result = steady.solve()
    assert isinstance(result, ertel.Result)
    with pytest.raises(ertel.CaseError, match="steady contact"):
        case.solve(start=result)


def test_a_study_over_time_has_figures_of_whole_runs(case: ertel.Case, solved: ertel.Transient, tmp_path: Path, cases: Path) -> None:
    lowest = solved.over_time["film_minimum_lowest"]
    films = solved.series("film_minimum")
    assert lowest["value"] == films.min() and lowest["time"] == solved.time[films.argmin()] and lowest["resolved"]
    load = '[transient.load]\ncourse = "ramp"\nstart = "0.1 ms"\nend = "0.3 ms"\nto = "50 kN/m"\n'
    text = f'{(cases / "roller.toml").read_text()}\n[transient]\nduration = "0.5 ms"\noutput_times = ["0 ms", "0.3 ms"]\n{load}'
    (tmp_path / "case.toml").write_text(text)
    study = {
        "case": str(tmp_path / "case.toml"),
        "axis": [{"key": "transient.load.to", "values": ["50 kN/m", "120 kN/m"]}],
    }
    rows = ertel.sweep(study, tmp_path / "out", folders=True)
    assert rows["converged"].all() and len(rows) == 2
    assert rows["film_minimum_lowest_m"][0] == pytest.approx(lowest["value"], rel=1e-6)
    # More load, less film and more pressure.
    assert rows["film_central_last_m"][1] < rows["film_central_last_m"][0]
    assert rows["pressure_maximum_highest_Pa"][1] > rows["pressure_maximum_highest_Pa"][0]
    found = ertel.read(tmp_path / "out")
    run = found.point(2)
    assert isinstance(run, ertel.Transient) and run.over_time["film_central_last"]["value"] == rows["film_central_last_m"][1]
    assert found.plot("film_minimum_lowest") is not None

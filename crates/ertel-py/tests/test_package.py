"""The package against the program, and as its users use it."""

from __future__ import annotations

import gc
import json
import math
import os
import pickle
import subprocess
import sys
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from importlib.metadata import files
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ertel


def without_times(document: dict[str, Any]) -> dict[str, Any]:
    """Parts that do not depend on the clock or on memory."""
    document = json.loads(json.dumps(document))
    stats = document["stats"]
    stats.pop("wall_seconds"), stats.pop("peak_memory", None)
    for level in stats["levels"]:
        level.pop("seconds")
    return document


@pytest.mark.parametrize("name", ["roller", "ball-on-disc", "cylindrical-roller"])
def test_same_bits_as_the_program(name: str, cases: Path, program: str, tmp_path: Path) -> None:
    subprocess.run(
        [program, "solve", cases / f"{name}.toml", "--output", tmp_path / "own", "--quiet", "--accept-unresolved"],
        check=True,
    )
    result = ertel.Case.from_file(cases / f"{name}.toml").solve()
    assert isinstance(result, ertel.Result)
    result.save(tmp_path / "python")
    own = json.loads((tmp_path / "own" / "result.json").read_text())
    assert without_times(result.to_dict()) == without_times(own)
    for file in ["centreline.csv", "surface.vtu", "film.svg", "case.toml"]:
        path = tmp_path / "own" / file
        if path.exists():
            assert (tmp_path / "python" / file).read_bytes() == path.read_bytes(), file


def test_keywords_say_what_a_file_says(line: dict[str, Any]) -> None:
    case = ertel.Case(**line)
    text = """
        [contact]
        kind = "line"
        radius = "10 mm"
        load = "100 kN/m"
        [bodies]
        body_1 = "steel"
        body_2 = "steel"
        [motion]
        entrainment_speed = "2 m/s"
        slide_to_roll_ratio = 0.0
        [lubricant]
        temperature = "40 degC"
        density = { law = "dowson-higginson", rho_0 = "870 kg/m^3" }
        viscosity = { law = "roelands", mu_0 = "40 mPa.s", alpha = "20 1/GPa" }
        [mesh]
        target_error = "1 %"
    """
    assert case.si == ertel.Case.from_text(text).si
    # E' of steel on steel, p_h by hand
    modulus = 210e9 / (1 - 0.3**2)
    assert case.estimate()["hertz"]["pressure"] == pytest.approx(math.sqrt(1e5 * modulus / (2 * math.pi * 0.01)), rel=1e-3)


def test_pint_quantities(line: dict[str, Any]) -> None:
    pint = pytest.importorskip("pint")
    unit = pint.UnitRegistry()
    plain = ertel.Case(**line)
    line["contact"]["radius"] = 1.0 * unit.cm
    line["contact"]["load"] = 100.0 * unit.newton / unit.millimeter
    line["motion"]["entrainment_speed"] = 120.0 * unit.meter / unit.minute
    line["lubricant"]["viscosity"]["mu_0"] = 40.0 * unit.millipascal * unit.second
    for key, value in ertel.Case(**line).inputs.items():
        assert value == pytest.approx(plain.inputs[key], rel=1e-14), key
    line["contact"]["radius"] = 1.0 * unit.second
    with pytest.raises(ertel.CaseError, match="radius"):
        ertel.Case(**line)
    line["contact"]["radius"] = 1.0 * unit.ampere
    with pytest.raises(ertel.CaseError, match="not known"):
        ertel.Case(**line)


@pytest.mark.parametrize(
    ("section", "key", "value", "words"),
    [
        ("contact", "radius", "-1 mm", "radius"),
        ("contact", "radius", "16 s", "radius"),
        ("contact", "radius", 0.016, "radius"),
        ("contact", "radios", "16 mm", "unknown key"),
        ("contact", "kind", "cube", "kind"),
        ("motion", "slide_to_roll_ratio", math.nan, "slide_to_roll_ratio"),
        ("bodies", "body_1", "wood", "wood"),
        ("bodies", "body_1", object(), "bodies.body_1"),
        ("mesh", "target_error", "1 mm", "target_error"),
    ],
)
def test_bad_input(line: dict[str, Any], section: str, key: str, value: object, words: str) -> None:
    line[section][key] = value
    with pytest.raises(ertel.CaseError, match=words):
        ertel.Case(**line)


def test_messages_are_those_of_the_program(program: str, tmp_path: Path) -> None:
    path = tmp_path / "bad.toml"
    path.write_text('[contact]\nkind = "line"\nradius = "-1 mm"\n')
    found = subprocess.run([program, "solve", path], capture_output=True, text=True, check=False)
    assert found.returncode == 2
    with pytest.raises(ertel.CaseError) as error:
        ertel.Case.from_file(path)
    assert found.stderr.strip() == f"error: {error.value}"


def test_no_convergence(line: dict[str, Any]) -> None:
    line["solver"] = {"max_iterations": 1}
    with pytest.raises(ertel.ConvergenceError, match="no convergence in stage") as error:
        ertel.Case(**line).solve()
    assert "residual" in error.value.report and "start" in error.value.report
    assert error.value.report == str(error.value)


def test_fields(line: dict[str, Any]) -> None:
    result = ertel.Case(**line).solve()
    assert isinstance(result, ertel.Result)
    assert result.points.shape == (len(result.pressure), 2) and result.triangles.shape[1] == 2
    assert result.pressure is result.pressure, "a copy"
    # The load, N/m, by the trapezoidal rule
    order = np.argsort(result.points[:, 0])
    load = np.trapezoid(result.pressure[order], result.points[order, 0])
    assert load == pytest.approx(1e5, rel=1e-3)
    assert float(result.film_central) == result.to_dict()["figures"]["film_central"]["value"]
    with pytest.raises(AttributeError, match="temperature_mid"):
        _ = result.temperature_mid
    with pytest.raises(AttributeError, match="no attribute"):
        _ = result.presure
    with pytest.raises(KeyError, match="film_thickness"):
        result.field("film")
    assert result.sensitivities["film_central"]["contact.load"] < 0.0
    figures = result.figures()
    assert list(figures.index) == list(result.to_dict()["figures"]), "every figure of the result"
    assert result.figure("friction_power") == result.friction_power and result.friction_power.unit == "W/m"
    assert float(result.film_centreline_minimum) == pytest.approx(float(result.film_minimum), rel=1e-3)
    assert result.heat_shear is None, "there is no heat"
    assert result.pressure_maximum.place == (figures.loc["pressure_maximum", "x"], 0.0)
    with pytest.raises(KeyError, match="roller_moment"):
        result.figure("moment")
    assert "h_c" in repr(result) and "<table>" in result._repr_html_()


def test_ball_fields_are_whole(cases: Path) -> None:
    pytest.importorskip("xarray")
    text = (cases / "ball-on-disc.toml").read_text() + '\n[mesh]\ntarget_error = "2 %"\n'
    result = ertel.Case.from_text(text).solve()
    assert isinstance(result, ertel.Result)
    x, y = result.points.T
    assert y.min() == -y.max() < 0.0
    corners = result.points[result.triangles]
    sides = corners[:, 1:] - corners[:, :1]
    areas = 0.5 * (sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0])
    assert areas.min() > 0.0
    load = (areas * result.pressure[result.triangles].mean(axis=1)).sum()
    assert load == pytest.approx(100.0, rel=2e-3)
    grid = result.to_xarray(101)
    assert grid.pressure.dims == ("y", "x") and grid.pressure.attrs["units"] == "Pa"
    centre = grid.film_thickness.sel(x=0.0, y=0.0, method="nearest")
    assert float(centre) == pytest.approx(float(result.film_central), rel=0.02)
    np.testing.assert_allclose(grid.pressure.values, grid.pressure.values[::-1], rtol=1e-6, atol=1e3)
    whole = result.to_xarray(21, extent=(x.min() * 1.1, x.max(), y.min(), y.max()))
    assert np.isnan(whole.pressure.values[:, 0]).all()


def test_exports(line: dict[str, Any], tmp_path: Path) -> None:
    result = ertel.Case(**line).solve()
    assert isinstance(result, ertel.Result)
    pytest.importorskip("pandas")
    table = result.to_pandas()
    assert list(table.columns[:3]) == ["x", "y", "pressure"] and len(table) == len(result.points)
    assert result.figures().loc["film_central", "unit"] == "m"
    pyvista = pytest.importorskip("pyvista")
    grid = result.to_pyvista()
    assert isinstance(grid, pyvista.UnstructuredGrid) and grid.n_cells == len(result.triangles)
    pytest.importorskip("matplotlib")
    for picture in [result.plot(), result.plot("film_thickness")]:
        picture.savefig(tmp_path / "picture.png")
        assert (tmp_path / "picture.png").stat().st_size > 5000
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "thesis.txt").write_text("precious")
    with pytest.raises(ertel.OutputError):
        result.save(tmp_path / "mine")
    assert (tmp_path / "mine" / "thesis.txt").read_text() == "precious"


def test_uncertain_inputs_bring_a_second_bar(line: dict[str, Any]) -> None:
    line["lubricant"]["viscosity"]["mu_0"] = "40 mPa.s ± 10 %"
    result = ertel.Case(**line).solve()
    assert isinstance(result, ertel.Result)
    film = result.film_central
    exponent = result.sensitivities["film_central"]["lubricant.viscosity.mu_0"]
    assert film.uncertainty == pytest.approx(0.1 * exponent * film.value, rel=1e-6)
    assert "inputs ±" in str(film)


def test_figures_have_the_digits_that_their_bars_leave_certain() -> None:
    from ertel._quantity import _with_bar

    shown = {(249.4512, 0.1523): "249.45 ± 0.15", (237.5912, 0.038): "237.59 ± 0.04", (237.592004, 0.00026): "237.5920 ± 0.0003", (820.14, 340.0): "820 ± 340"}
    shown |= {(1234.5, 57.0): "1230 ± 60", (0.033708, 0.0000387): "0.03371 ± 0.00004", (0.0, 0.0): "0 ± 0"}
    for (value, error), text in shown.items():
        assert _with_bar(value, error) == text
    assert _with_bar(12.3456789, None) == "12.346"


def test_curves(line: dict[str, Any]) -> None:
    pytest.importorskip("pandas")
    line["curve"] = {"quantity": "motion.entrainment_speed", "values": ["1 m/s", "2 m/s", "4 m/s"]}
    events: list[dict[str, Any]] = []
    curve = ertel.Case(**line).solve(progress=events.append)
    assert isinstance(curve, ertel.Curve) and len(curve) == 3 and not curve.failures
    films = curve.to_pandas()["film_central_m"].to_numpy()
    # Hardly more or less than speed to the power 0.7
    assert np.allclose(np.diff(np.log(films)) / np.log(2.0), 0.68, atol=0.04)
    assert [e["point"] for e in events if e["event"] == "point"] == [1, 2, 3]
    assert len(pickle.loads(pickle.dumps(curve)).to_pandas()) == 3


def test_warm_start(line: dict[str, Any]) -> None:
    # Finite volumes start from the dry contact.
    line["solver"] = {"method": "finite-elements"}
    first = ertel.Case(**line).solve()
    assert isinstance(first, ertel.Result)
    line["contact"]["load"] = "101 kN/m"
    warm, cold = ertel.Case(**line).solve(start=first), ertel.Case(**line).solve()
    assert isinstance(warm, ertel.Result) and isinstance(cold, ertel.Result)
    assert warm.to_dict()["stats"]["warm"] and not cold.to_dict()["stats"]["warm"]
    assert float(warm.film_central) == pytest.approx(float(cold.film_central), rel=0.01)


def solve(case: ertel.Case) -> ertel.Result:
    result = case.solve()
    assert isinstance(result, ertel.Result)
    return result


def test_ten_solves_at_a_time_in_threads_and_processes(line: dict[str, Any]) -> None:
    cases = []
    for speed in range(1, 11):
        line["motion"]["entrainment_speed"] = f"{speed} m/s"
        cases.append(ertel.Case(**line))
    alone = [float(solve(case).film_central) for case in cases]
    with ThreadPoolExecutor(10) as threads:
        assert [float(r.film_central) for r in threads.map(solve, cases)] == alone
    with ProcessPoolExecutor(2) as processes:
        results = list(processes.map(solve, cases))
    assert [float(r.film_central) for r in results] == alone
    assert results[0].pressure.max() > 1e8 and results[0].case == cases[0]
    with pytest.raises(RuntimeError, match="pickled"):
        results[0].save("nowhere")


def test_other_threads_run_on(cases: Path) -> None:
    case = ertel.Case.from_file(cases / "ball-on-disc.toml")
    ticks = []

    with ThreadPoolExecutor(1) as threads:
        solved = threads.submit(solve, case)
        while not solved.done():
            ticks.append(time.monotonic())
            time.sleep(0.01)
    assert len(ticks) > 20 and max(np.diff(ticks)) < 0.5


@pytest.mark.skipif(os.name != "posix", reason="signals")
def test_interrupt(cases: Path, interrupted: Callable[[str, float], None]) -> None:
    interrupted(f"case = ertel.Case.from_file({str(cases / 'squalane-thermal.toml')!r})\n", 5.0)


def test_exceptions_of_progress_stop_the_solve(line: dict[str, Any]) -> None:
    def fail(event: dict[str, Any]) -> None:
        raise LookupError(event["event"])

    with pytest.raises(LookupError, match="stage"):
        ertel.Case(**line).solve(progress=fail)


def test_studies(line: dict[str, Any], tmp_path: Path) -> None:
    pytest.importorskip("pandas")
    (tmp_path / "line.toml").write_text(ertel.Case(**line).text)
    study = tmp_path / "speeds.toml"
    study.write_text(
        'case = "line.toml"\n[[axis]]\nkey = "motion.entrainment_speed"\nvalues = ["1 m/s", "2 m/s", "3 m/s"]\n'
    )
    table = ertel.sweep(study, tmp_path / "out")
    assert len(table) == 3 and table.attrs["summary"]["n_new"] == 3
    again = ertel.sweep(study, tmp_path / "out")
    assert again.attrs["summary"]["n_kept"] == 3 and again.equals(table)
    keys = {
        "case": tmp_path / "line.toml",
        "axis": [{"key": "motion.entrainment_speed", "values": ["1 m/s", "2 m/s", "3 m/s"]}],
    }
    by_keys = ertel.sweep(keys, tmp_path / "by keys")
    assert by_keys.equals(table)
    with pytest.raises(ertel.CaseError, match="folder"):
        ertel.sweep(keys)
    keys["axis"] = [{"key": "motion.speed", "values": ["1 m/s"]}]
    with pytest.raises(ertel.CaseError, match="made in Python"):
        ertel.sweep(keys, tmp_path / "none")
    study.write_text('case = "line.toml"\n[[axis]]\nkey = "motion.speed"\nvalues = ["1 m/s"]\n')
    with pytest.raises(ertel.CaseError, match="speed"):
        ertel.sweep(study, tmp_path / "out")


def test_data_and_fits(root: Path, tmp_path: Path, line: dict[str, Any]) -> None:
    assert len(ertel.fluids()) >= 30 and "squalane-pip" in ertel.fluids() and "steel" in ertel.solids()
    rising = ertel.viscosity("squalane-pip", [[0.0, 1e8], [2e8, 5e8]], 313.15)
    assert rising.shape == (2, 2) and (np.diff(rising.ravel()) > 0.0).all()
    with pytest.raises(ertel.CaseError, match="squalane"):
        ertel.viscosity("squalene-pip", 0.0, 313.15)
    table = root / "validation" / "appendix-c" / "fluid-a.csv"
    fit = ertel.fit_viscosity(table, "roelands")
    assert fit.rms < 0.1 and "mu_0" in fit.constants
    fit.save(tmp_path / "mine.toml")
    with pytest.raises(ertel.OutputError):
        fit.save(tmp_path / "mine.toml")
    line["lubricant"] = {"name": "mine.toml", "temperature": "40 degC", "density": line["lubricant"]["density"]}
    assert float(solve(ertel.Case(folder=tmp_path, **line)).film_central) > 1e-8
    with pytest.raises(ertel.CaseError, match="roelands"):
        ertel.fit_viscosity(table, "reynolds")
    # A data sheet without pressures.
    sheet = root / "cases" / "data-sheet-oil.csv"
    with pytest.raises(ertel.CaseError, match="density"):
        ertel.fit_viscosity(sheet, "walther")
    with pytest.raises(ertel.CaseError, match="alpha"):
        ertel.fit_viscosity(sheet, "walther", density="iso-vg-46-mineral")
    oil = ertel.fit_viscosity(
        sheet, "walther", density="iso-vg-46-mineral", hold={"alpha": "22 1/GPa"}, reference_temperature="40 degC"
    )
    assert abs(oil.constants["a"] - 9.3247) < 0.01 and "[density]" in oil.text


def test_fluids_by_name(tmp_path: Path) -> None:
    squalane = ertel.fluid("squalane-pip")
    assert "squalane" in squalane.title.lower() and squalane.viscosity_law and squalane.density_law
    assert squalane.viscosity(0.0, 313.15) == ertel.viscosity("squalane-pip", 0.0, 313.15)
    density = squalane.density([0.0, 1e9], 313.15)
    assert 700.0 < density[0] < density[1] < 1200.0
    assert any(source for _, source in squalane.sources.values())
    with pytest.raises(ertel.CaseError, match="squalane"):
        ertel.fluid("squalene-pip")


def test_fits_of_films(tmp_path: Path) -> None:
    # h = 2e-7 u^0.67 to the digit: the fit gives its constants back.
    rows = [f"{u},{2e-7 * u**0.67!r}" for u in (0.1, 0.2, 0.5, 1.0, 2.0)]
    table = tmp_path / "films.csv"
    table.write_text("entrainment_speed_m_per_s,film_central_m\n" + "\n".join(rows) + "\n")
    fits = ertel.fit_film(table, "speed")
    central = fits["central"]
    assert list(fits) == ["central"] and central.rms < 1e-9
    c, a = central.constants.values()
    assert c == pytest.approx(2e-7, rel=1e-6) and a == pytest.approx(0.67, rel=1e-6)
    for wrong, message in ({"form": "moss"}, "moes"), ({"form": "speed", "radius": -1.0}, "above zero"):
        with pytest.raises(ertel.CaseError, match=message):
            ertel.fit_film(table, **wrong)


def test_fits_of_stribeck_curves(cases: Path, tmp_path: Path) -> None:
    # Friction of the solved case itself: its constants come back.
    text, _, _ = (cases / "stribeck.toml").read_text().partition("[curve]")
    case = tmp_path / "case.toml"
    case.write_text(text)
    speeds = (1.0, 0.3, 0.1, 0.02)
    rough = ertel.Case.from_text(text)
    frictions = [rough.with_({"motion.entrainment_speed": f"{u} m/s"}).solve().figure("friction_total") for u in speeds]
    rows = [f"{u},{abs(friction.value)!r}" for u, friction in zip(speeds, frictions)]
    table = tmp_path / "friction.csv"
    table.write_text("entrainment_speed [m/s],traction_coefficient\n" + "\n".join(rows) + "\n")
    fit = ertel.fit_stribeck(case, table)
    friction, height = fit.constants["boundary_friction_coefficient"], fit.constants["rms_height"]
    assert friction == pytest.approx(0.12, rel=1e-3) and height == pytest.approx(0.25e-6, rel=5e-3)
    assert [point["line"] for point in fit.points] == [2, 3, 4, 5]
    assert "[surface_roughness]" in fit.section
    with pytest.raises(ertel.CaseError, match="curve"):
        ertel.fit_stribeck(cases / "stribeck.toml", table)


def test_comparisons(cases: Path, tmp_path: Path) -> None:
    pytest.importorskip("pandas")
    measured = tmp_path / "measured.csv"
    lines = [line for line in (cases / "measured-films.csv").read_text().splitlines() if not line.startswith("#")]
    measured.write_text("\n".join([lines[0], *lines[1:3]]) + "\n")
    table = ertel.compare(cases / "measured-films.toml", measured, tmp_path / "out")
    assert len(table) == 2 and "bias" in table.attrs["report"]
    computed, known = table["film_central_computed_m"], table["film_central_measured_m"]
    # The table of the guide: 13 to 18 % too thin at these speeds with the oil that is assumed.
    assert ((computed / known - 1.0).between(-0.19, -0.12)).all()
    measured.write_text("speed,film_central [nm]\n1,100\n")
    with pytest.raises(ertel.CaseError, match="measured.csv"):
        ertel.compare(cases / "measured-films.toml", measured, tmp_path / "out2")
    assert not (tmp_path / "out2").exists()
    # The same rows under titles that say nothing, with a decimal comma: the figures are the same.
    rows = ["a;b;c;d;e;f", *(line.replace(",", ";").replace(".", ",") for line in lines[1:3])]
    measured.write_text("\n".join(rows) + "\n")
    columns = {"entrainment speed": "a:mm/s", "load": "b:N", "temperature": "c:degC", "slide to roll ratio": "d:%", "film central": "e:nm"}
    found = ertel.compare(cases / "measured-films.toml", measured, tmp_path / "columns", columns=columns, decimal="comma")
    assert found["film_central_measured_m"].tolist() == pytest.approx(known.tolist())
    assert found["film_central_computed_m"].tolist() == pytest.approx(computed.tolist(), rel=1e-6)
    with pytest.raises(ertel.CaseError, match="comma"):
        ertel.compare(cases / "measured-films.toml", measured, tmp_path / "out3", columns=columns, decimal="dot")  # type: ignore[arg-type]
    with pytest.raises(ertel.CaseError, match="no column"):
        ertel.compare(cases / "measured-films.toml", measured, tmp_path / "out3", columns={"film central": "z"})


def test_import_is_quick() -> None:
    code = "import time, numpy; t = time.perf_counter(); import ertel; print(time.perf_counter() - t)"
    seconds = [float(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout) for _ in range(3)]
    assert min(seconds) < 0.3
    code = "import ertel, sys; print([m for m in ('pandas', 'xarray', 'matplotlib', 'pyvista', 'distributed') if m in sys.modules])"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout == "[]\n"


def test_the_package_is_small() -> None:
    size = sum(Path(str(file.locate())).stat().st_size for file in files("ertel") or [] if not str(file).endswith(".pyc"))
    assert size < 30e6


def resident() -> int:
    text = Path("/proc/self/status").read_text()
    return int(next(line.split()[1] for line in text.splitlines() if line.startswith("VmRSS")))


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="memory is read from /proc")
def test_no_leak(line: dict[str, Any]) -> None:
    """A thousand solves: what the last eight hundred leave would not hold one result each."""
    # Ten times as fast as finite volumes.
    case = ertel.Case(**line, solver={"method": "finite-elements"})
    for i in range(1000):
        result = solve(case)
        _ = result.pressure
        if i == 200:
            gc.collect()
            before = resident()
    gc.collect()
    assert resident() - before < 30_000, "kB"


def test_stresses(cases: Path) -> None:
    result = ertel.Case.from_file(cases / "stresses.toml").solve()
    profile, section = result.stress_profile(1), result.stress_section(2)
    assert profile["depth"].shape == profile["xz"].shape == (61,)
    assert section["xx"].shape == (61, section["x"].size)
    # The surface carries the pressure.
    assert -profile["zz"][0] == pytest.approx(float(result.pressure_central), rel=0.02)
    with pytest.raises(KeyError, match="no body 3"):
        result.stress_profile(3)

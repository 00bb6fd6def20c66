"""Settings, units, and what other packages read."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ertel


@pytest.fixture
def result(line: dict[str, Any]) -> ertel.Result:
    line["motion"]["slide_to_roll_ratio"] = 0.1
    found = ertel.Case(title="line", **line).solve()
    assert isinstance(found, ertel.Result)
    return found


def test_settings(line: dict[str, Any]) -> None:
    case = ertel.Case(**line)
    other = case.with_({"motion.entrainment_speed": "4 m/s", "motion.slide_to_roll_ratio": 0.5, "solver.isothermal": True})
    assert other.si["motion"]["entrainment_speed"] == 4.0 and other.inputs["motion.slide_to_roll_ratio"] == 0.5
    assert case.si["motion"]["entrainment_speed"] == 2.0, "the case itself is as before"
    line["motion"] = {"entrainment_speed": "4 m/s", "slide_to_roll_ratio": 0.5}
    assert other.given["motion"] == ertel.Case(**line).given["motion"]
    assert case.with_({"bodies.body_2": {"youngs_modulus": "70 GPa", "poissons_ratio": 0.3}}).si["body_2"]["youngs_modulus"] == 70e9
    assert case.with_({"title": 'a "b" = c'}).title == 'a "b" = c'
    assert case.with_({}) == case
    for settings, words in [
        ({"contact.laod": "5 N"}, "unknown key `laod`.*load"),
        ({"contact.load": "5 N"}, "force per length"),
        ({"contact.load": 5}, "has no unit"),
        ({"contact.load=3": 5}, "no key path"),
        ({3: "5 N"}, "no key path"),
        ({"mesh.preset": "finest"}, "(?s)preset.*normal"),
        ({"contact.load": object()}, "contact.load"),
        (["contact.load=5"], "a mapping"),
    ]:
        with pytest.raises(ertel.CaseError, match=f"(?s){words}"):
            case.with_(settings)  # type: ignore[arg-type]


def test_quantities_of_pint(line: dict[str, Any], result: ertel.Result) -> None:
    pint = pytest.importorskip("pint")
    units = pint.UnitRegistry()
    case = ertel.Case(**line).with_({"motion.entrainment_speed": 7.2 * units.km / units.hour})
    assert case.si["motion"]["entrainment_speed"] == pytest.approx(2.0)
    film = result.film_central.to_pint(units)
    assert film.to("nm").magnitude == pytest.approx(1e9 * float(result.film_central))
    for name, quantity in result._figures().items():
        assert quantity.to_pint(units).m == quantity.value, name
    assert result.friction_power.to_pint(units).check("[power]/[length]")
    assert result.traction_coefficient.to_pint().unitless


def test_netcdf(result: ertel.Result, tmp_path: Path) -> None:
    xr = pytest.importorskip("xarray")
    io = pytest.importorskip("scipy.io")
    path = result.to_netcdf(tmp_path / "line.nc", 51)
    assert path.read_bytes()[:4] == b"CDF\x02", "the classic format with 64-bit offsets"
    grid = result.to_xarray(51)
    assert sum(1 for name in grid.data_vars) > 5
    with xr.open_dataset(path, engine="scipy") as data:
        for name, values in grid.data_vars.items():
            np.testing.assert_array_equal(data[name].values, values.values)
            assert data[name].attrs["units"] == values.attrs["units"]
        assert data["film_central"].item() == float(result.film_central)
        assert data["friction_power"].attrs["units"] == "W/m" and data["film_central"].attrs["error"] == result.film_central.error
        np.testing.assert_array_equal(data["x"].values, grid["x"].values)
        place = result.film_minimum.place
        assert place is not None and (data["film_minimum"].attrs["x"], data["film_minimum"].attrs["y"]) == place
        assert set(result.to_dict()["figures"]) | set(grid.data_vars) == set(data.data_vars)
        assert data.attrs["kind"] == "line" and data.attrs["title"] == "line" and data.attrs["source"] == f"ertel {ertel.__version__}"
    with io.netcdf_file(path, mmap=False) as file:
        assert file.variables["pressure"].units == b"Pa" and file.variables["pressure"].shape == (51,)
        assert file.variables["pressure_maximum"].resolved == int(result.pressure_maximum.resolved)
    with pytest.raises(ertel.OutputError, match="missing"):
        result.to_netcdf(tmp_path / "missing" / "line.nc")


def test_netcdf_of_the_program(program: str, cases: Path, tmp_path: Path) -> None:
    """`[output] netcdf = true`: an independent reader finds figures of result.json and fields of surface.vtu; Python writes the same bytes."""
    io = pytest.importorskip("scipy.io")
    interpolate = pytest.importorskip("scipy.interpolate")
    out = tmp_path / "out"
    settings = ["output.netcdf=true", "mesh.target_error=5 %", "output.pictures=[]"]
    command = [program, "solve", str(cases / "ball-on-disc.toml"), "--quiet", "--output", str(out)]
    subprocess.run([*command, *(word for setting in settings for word in ("--set", setting))], check=True)
    content = (out / "result.nc").read_bytes()
    result = ertel.read(out)
    assert isinstance(result, ertel.Result)
    assert result.to_netcdf(tmp_path / "again.nc").read_bytes() == content
    figures = json.loads((out / "result.json").read_text(encoding="utf-8"))["figures"]
    with io.netcdf_file(out / "result.nc", mmap=False) as file:
        for name, figure in figures.items():
            assert file.variables[name].getValue() == figure["value"]
            assert file.variables[name].units.decode() == (figure["unit"] or "1")
        x, y = (file.variables[axis][:].copy() for axis in "xy")
        pressure = file.variables["pressure"][:].copy()
    assert pressure.shape == (len(y), len(x)) and len(x) == 201
    assert np.diff(y)[0] == pytest.approx(np.diff(x)[0], rel=0.02)
    # By scipy's own triangulation, between the same points: the same surface up to the diagonals of the cells.
    linear = interpolate.LinearNDInterpolator(result.points, result.pressure)
    across, along = np.meshgrid(y, x, indexing="ij")
    assert np.nanmean(np.abs(pressure - linear(along, across))) < 1e-3 * result.hertz_pressure
    # The load of the case, by the sum over the grid.
    load = np.nansum(pressure) * np.diff(x)[0] * np.diff(y)[0]
    assert load == pytest.approx(result.case.si["contact"]["load"], rel=0.01)
    assert np.nanmax(pressure) == pytest.approx(float(result.pressure_maximum), rel=0.02)


def test_other_readers_of_the_surface(result: ertel.Result, tmp_path: Path) -> None:
    """meshio and pyvista read points, segments and fields, whose names have the units."""
    path = result.save(tmp_path / "out") / "surface.vtu"
    names = {name: f"{name}_{unit}" for name, unit in {"pressure": "Pa", "film_thickness": "m", "viscosity": "Pa_s"}.items()}
    meshio = pytest.importorskip("meshio")
    mesh = meshio.read(path)
    np.testing.assert_array_equal(mesh.points[:, 0], result.points[:, 0])
    np.testing.assert_array_equal(mesh.cells_dict["line"], result.triangles)
    for name, column in names.items():
        np.testing.assert_array_equal(mesh.point_data[column], result.field(name))
    pyvista = pytest.importorskip("pyvista")
    grid = pyvista.read(path)
    for name, column in names.items():
        np.testing.assert_array_equal(grid.point_data[column], result.field(name))
    own = result.to_pyvista()
    units = {"points": "m", "pressure": "Pa", "film_thickness": "m", "viscosity": "Pa.s"}
    for field_data, named in ((mesh.field_data, names), (grid.field_data, names), (own.field_data, {name: name for name in names})):
        given = json.loads(bytes(field_data["units"]))
        for name, unit in units.items():
            assert given[named.get(name, name)] == unit


def test_one_name_for_one_figure(result: ertel.Result, root: Path) -> None:
    """Names of figures in Python are those of JSON, of the tables and of the reference; bodies are numbers."""
    from ertel import _ertel

    names = [name for name, _, _ in _ertel.figure_names()]
    reference = (root / "docs/reference/results.md").read_text(encoding="utf-8")
    for name in names:
        assert f"| `{name}` |" in reference, name
        assert not set(name.split("_")) & {"ball", "plane"}, name
    assert set(result.to_dict()["figures"]) <= set(names)
    for name in [name for name, _, _ in _ertel.field_names()]:
        assert not set(name.split("_")) & {"ball", "plane"}, name


def test_no_figure_has_a_second_name(program: str, cases: Path, tmp_path: Path) -> None:
    """Of a thermal contact that slides, every entry anywhere in result.json that has value and bar of a figure has its name."""
    out = tmp_path / "out"
    settings = ["--set", "mesh.target_error=5 %", "--set", "output.pictures=[]"]
    subprocess.run([program, "solve", cases / "squalane-thermal.toml", "-q", "--accept-unresolved", "--output", out, *settings], check=True)
    content = json.loads((out / "result.json").read_text(encoding="utf-8"))
    figures = content.pop("figures")
    assert {"temperature_body_2_mean", "heat_to_body_1", "traction_coefficient_body_1", "film_temperature_lowest"} <= set(figures)
    of = {(entry["value"], entry["error"]): name for name, entry in figures.items() if entry["value"] != 0.0}
    found = set()

    def look(key: str, value: Any) -> None:
        if isinstance(value, dict):
            name = of.get((value.get("value"), value.get("error")))
            if name is not None:
                # Two figures may be equal: a film on the centreline is the smallest one.
                entry = figures.get(key.removesuffix("_at"))
                assert entry is not None and entry["value"] == value["value"], f"{key} is {name}"
                found.add(key)
            for inner, own in value.items():
                look(inner, own)
        elif isinstance(value, list):
            for own in value:
                look(key, own)

    look("", content)
    assert len(found) > 15


def test_optimisation_with_the_adjoint_gradient(line: dict[str, Any]) -> None:
    """The speed of a given film, by scipy with the gradient of the solve: the film of the solution is the one that was asked for."""
    optimize = pytest.importorskip("scipy.optimize")
    case = ertel.Case(**line)
    target = 1.5e-6
    key = "motion.entrainment_speed"

    def misfit(x: np.ndarray) -> tuple[float, np.ndarray]:
        result = case.with_({key: f"{np.exp(x[0])} m/s"}).solve()
        away = np.log(float(result.film_central) / target)
        return away**2, np.array([2.0 * away * result.sensitivities["film_central"][key]])

    found = optimize.minimize(misfit, [0.0], jac=True, method="BFGS", options={"gtol": 1e-4})
    film = case.with_({key: f"{np.exp(found.x[0])} m/s"}).solve().film_central
    assert float(film) == pytest.approx(target, rel=1e-3) and found.nfev < 20


def test_indices_of_sobol(line: dict[str, Any]) -> None:
    """SALib over formulas: the indices of a power law are those of its exponents."""
    pytest.importorskip("SALib")
    from SALib.analyze import sobol as analyze
    from SALib.sample import sobol as sample

    case = ertel.Case(**line)
    problem = {
        "num_vars": 2,
        "names": ["motion.entrainment_speed", "contact.load"],
        "bounds": [[1.0, 3.0], [50e3, 150e3]],
    }
    units = ["m/s", "N/m"]
    films = []
    for row in sample.sample(problem, 64, calc_second_order=False):
        settings = {key: f"{value!r} {unit}" for key, value, unit in zip(problem["names"], row.tolist(), units)}
        films.append(case.with_(settings).estimate()["formulas"][0]["film_central"])
    indices = analyze.analyze(problem, np.array(films), calc_second_order=False, seed=1)
    assert indices["S1"][0] > 0.9 and indices["S1"][1] < 0.1

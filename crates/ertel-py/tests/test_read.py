"""Folders of results, opened: what a fresh solve gives, and clear errors for all else."""

from __future__ import annotations

import json
import pickle
import re
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ertel


@pytest.fixture(scope="module")
def solved(tmp_path_factory: pytest.TempPathFactory, cases: Path) -> tuple[ertel.Result, Path]:
    """A ball, whose half is solved, with a result in a folder."""
    text = (cases / "ball-on-disc.toml").read_text() + '\n[mesh]\ntarget_error = "2 %"\n'
    result = ertel.Case.from_text(text).solve()
    assert isinstance(result, ertel.Result)
    return result, result.save(tmp_path_factory.mktemp("read") / "ball")


def copied(folder: Path, target: Path) -> Path:
    shutil.copytree(folder, target / "copy")
    return target / "copy"


def test_a_result_is_that_of_the_solve(solved: tuple[ertel.Result, Path]) -> None:
    result, folder = solved
    again = ertel.read(folder)
    assert isinstance(again, ertel.Result) and again.folder == folder and result.folder is None
    assert again.to_dict()["figures"] == result.to_dict()["figures"]
    for name, quantity in result._figures().items():
        assert again.figure(name) == quantity == getattr(again, name)
    assert again.report == result.report and again.warnings == result.warnings and repr(again) == repr(result)
    assert again.case.text == result.case.text and again.case.si == result.case.si
    assert again.field_names == result.field_names
    np.testing.assert_array_equal(again.points, result.points)
    np.testing.assert_array_equal(again.triangles, result.triangles)
    for name in result.field_names:
        np.testing.assert_array_equal(again.field(name), result.field(name))
    assert list(again.centreline) == list(result.centreline)
    for name, values in result.centreline.items():
        np.testing.assert_allclose(again.centreline[name], values, rtol=1e-8)
    pytest.importorskip("xarray")
    assert again.to_xarray(41).equals(result.to_xarray(41))
    pytest.importorskip("matplotlib")
    again.plot(), again.plot("film_thickness")
    kept = pickle.loads(pickle.dumps(again))
    assert kept.film_central == result.film_central and kept.pressure.max() == result.pressure.max()
    with pytest.raises(ertel.OutputError, match="solve its case again"):
        again.save("nowhere")


def test_results_of_the_program(program: str, cases: Path, tmp_path: Path) -> None:
    for name, settings in {"roller": [], "squalane-thermal": ["--set", "mesh.target_error=5 %"]}.items():
        folder = tmp_path / name
        subprocess.run([program, "solve", cases / f"{name}.toml", "-q", "--accept-unresolved", "--output", folder, *settings], check=True)
        result = ertel.read(folder)
        assert isinstance(result, ertel.Result)
        table = json.loads((folder / "result.json").read_text())["figures"]
        assert {n: [q.value, q.error, q.unit] for n, q in result._figures().items()} == {
            n: [e["value"], e["error"], e["unit"]] for n, e in table.items()
        }
        assert result.is_line == (name == "roller") and result.triangles.shape[1] == (2 if result.is_line else 3)
        assert result.pressure.max() == pytest.approx(float(result.pressure_maximum), rel=0.02)
    assert result.temperature_body_1_maximum.value > 300.0 and "temperature_mid" in result.field_names


def test_curves(line: dict[str, Any], tmp_path: Path) -> None:
    pytest.importorskip("pandas")
    line["curve"] = {"quantity": "motion.entrainment_speed", "values": ["1 m/s", "2 m/s", "4 m/s"]}
    curve = ertel.Case(**line).solve()
    assert isinstance(curve, ertel.Curve)
    again = ertel.read(curve.save(tmp_path / "curve"))
    assert isinstance(again, ertel.Curve) and len(again) == 3 and not again.failures
    assert again.to_pandas().equals(curve.to_pandas()) and again.report == curve.report and again.to_dict() == curve.to_dict()
    assert again.case.text == curve.case.text
    for content in ["", "a,b\n1,2,3,4\n1,2\n", 'a,b\n"1,2\n']:
        (tmp_path / "curve" / "curve.csv").write_text(content)
        with pytest.raises(ertel.OutputError, match="curve.csv: damaged, it is no table"):
            ertel.read(tmp_path / "curve").to_pandas()
    pytest.importorskip("matplotlib")
    axes = again.plot().axes[0]
    assert [text.get_color() for text in axes.get_lines()][0] == "#0072B2", "the first colour of the program"
    drawn = axes.get_lines()[0].get_ydata()
    np.testing.assert_allclose(drawn, 1e9 * again.to_pandas()["film_central_m"])
    assert "(nm)" in axes.get_ylabel() and axes.get_xlabel() == "entrainment speed (m/s)"
    with pytest.raises(KeyError, match="film_minimum"):
        again.plot("film")


def test_machines(cases: Path, tmp_path: Path) -> None:
    text = (cases / "machine" / "fzg-c.toml").read_text()
    case = ertel.Case.from_text(text).with_({"machine.points": 3})
    machine = case.solve()
    assert isinstance(machine, ertel.MachineSolution)
    again = ertel.read(machine.save(tmp_path / "gears"))
    assert isinstance(again, ertel.MachineSolution)
    assert again.figures == machine.figures and again.contacts == machine.contacts
    assert again.report == machine.report and again.table == machine.table and again.case.text == machine.case.text
    assert again.governing_contact == machine.governing_contact


def study_of(line: dict[str, Any], tmp_path: Path, **options: Any) -> Path:
    (tmp_path / "line.toml").write_text(ertel.Case(**line).text)
    keys = {
        "title": "speeds and loads",
        "case": tmp_path / "line.toml",
        "axis": [
            {"key": "motion.entrainment_speed", "values": ["1 m/s", "2 m/s", "3 m/s"]},
            {"key": "contact.load", "values": ["50 kN/m", "100 kN/m"]},
        ],
    }
    ertel.sweep(keys, tmp_path / "study", **options)
    return tmp_path / "study"


def test_studies(line: dict[str, Any], tmp_path: Path) -> None:
    pd = pytest.importorskip("pandas")
    folder = study_of(line, tmp_path, folders=True)
    study = ertel.read(folder)
    assert isinstance(study, ertel.Study) and (study.n_points, study.n_finished, study.failures) == (6, 6, [])
    assert study.title == "speeds and loads" and study.table == (folder / "results.csv").read_text()
    assert study.to_pandas().equals(pd.read_csv(folder / "results.csv"))
    point = study.point(4)
    assert isinstance(point, ertel.Result) and float(point.film_central) == study.to_pandas()["film_central_m"][3]
    for number in (0, 7):
        with pytest.raises(ertel.OutputError, match="1 to 6"):
            study.point(number)
    pytest.importorskip("matplotlib")
    axes = study.plot("film_minimum").axes[0]
    assert len(axes.containers) == 2, "a curve for each load"
    assert all(re.fullmatch(r"load \d+ kN/m", curve.get_label()) for curve in axes.containers)
    with pytest.raises(KeyError, match="contact"):
        study.plot(x="contact.load")
    # A journal that is gone, of something else, or damaged in part.
    journal = folder / "journal.jsonl"
    whole = journal.read_text()
    journal.unlink()
    with pytest.raises(ertel.OutputError, match="journal"):
        ertel.read(folder)
    journal.write_text("nothing of the kind\n" * 6)
    with pytest.raises(ertel.OutputError, match="journal"):
        ertel.read(folder)
    journal.write_text("\n".join(["damaged" if i == 1 else own for i, own in enumerate(whole.splitlines())]) + "\n")
    damaged = ertel.read(folder)
    assert isinstance(damaged, ertel.Study) and (damaged.n_finished, damaged.n_damaged) == (5, 1)
    journal.write_text(whole)
    # A run that was killed after two points, and its table before it was written.
    (folder / "results.csv").unlink()
    lines = (folder / "journal.jsonl").read_text().splitlines(keepends=True)
    (folder / "journal.jsonl").write_text("".join(lines[:2]) + lines[2][:30])
    begun = ertel.read(folder)
    assert isinstance(begun, ertel.Study) and begun.n_finished == 2 and len(begun.to_pandas()) == 2
    shutil.rmtree(folder / "points")
    with pytest.raises(ertel.OutputError, match="folders=True"):
        begun.point(1)
    (folder / "study.json").write_text('{"format": "ertel-study"')
    with pytest.raises(ertel.OutputError, match=r"study\.json"):
        ertel.read(folder)


def test_samples_of_the_program(program: str, cases: Path, tmp_path: Path) -> None:
    case = cases / "roller-uncertain.toml"
    subprocess.run([program, "solve", case, "-q", "--monte-carlo", "8", "--output", tmp_path / "r"], check=True)
    samples = ertel.read(tmp_path / "r-monte-carlo")
    assert isinstance(samples, ertel.MonteCarlo) and samples.n_samples == samples.n_solved == len(samples) == 8
    statistics = tmp_path / "r-monte-carlo" / "monte-carlo.json"
    whole = statistics.read_text()
    for old, new, words in [('"format_version": 2', '"format_version": 9', "version 9"), ('"ertel-monte-carlo"', '"other"', "no file of ertel")]:
        statistics.write_text(whole.replace(old, new))
        with pytest.raises(ertel.OutputError, match=words):
            ertel.read(tmp_path / "r-monte-carlo")
    # Statistics had no format in version 1: the error gives the reason and advice.
    statistics.write_text(json.dumps({key: value for key, value in json.loads(whole).items() if key in ("samples", "solved", "figures")}))
    with pytest.raises(ertel.OutputError, match=r"monte-carlo\.json: it has no `format`: an older ertel wrote it"):
        ertel.read(tmp_path / "r-monte-carlo")
    film = samples.figures["film_central"]
    pytest.importorskip("pandas")
    films = samples.to_pandas()["film_central_m"]
    assert film.mean == pytest.approx(films.mean()) and film.standard == pytest.approx(films.std())
    assert films.min() <= film.quantiles[0.5] <= films.max() and film.correlations
    pytest.importorskip("matplotlib")
    axes = samples.plot("film_central").axes[0]
    assert len(axes.containers) == 1 and axes.containers[0].lines[0].get_linestyle() == "None", "a point for each sample"


def test_comparisons(cases: Path, tmp_path: Path) -> None:
    pytest.importorskip("pandas")
    rows = [row for row in (cases / "measured-films.csv").read_text().splitlines() if not row.startswith("#")]
    (tmp_path / "measured.csv").write_text("\n".join(rows[:3]) + "\n")
    table = ertel.compare(cases / "measured-films.toml", tmp_path / "measured.csv", tmp_path / "out")
    found = ertel.read(tmp_path / "out")
    assert isinstance(found, ertel.Comparison) and len(found) == 2
    assert found.to_pandas().equals(table) and found.report == table.attrs["report"]
    assert "film_central" in found.statistics and found.study.n_finished == 2
    for name in ("comparison.json", "comparison.csv", "report.txt", "case.toml"):
        (tmp_path / "out" / name).unlink()
    with pytest.raises(ertel.OutputError, match="not finished"):
        ertel.read(tmp_path / "out")


def test_folders_that_are_none(solved: tuple[ertel.Result, Path], tmp_path: Path) -> None:
    with pytest.raises(ertel.OutputError, match="nowhere: no such result folder"):
        ertel.read(tmp_path / "nowhere")
    with pytest.raises(ertel.OutputError, match="it is a file"):
        ertel.read(solved[1] / "result.json")
    with pytest.raises(ertel.OutputError, match="no results of ertel: none of result.json"):
        ertel.read(tmp_path)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda text: text[: len(text) // 2], "damaged, it is no JSON"),
        (lambda text: "", "no JSON"),
        (lambda text: "[" * 100_000, "damaged"),
        (lambda text: "[]", "no file of ertel"),
        (lambda text: text.replace('"ertel-result"', '"other"'), "no file of ertel"),
        (lambda text: text.replace('"format_version": 2', '"format_version": 3'), "layout is version 3, written by ertel"),
        (lambda text: text.replace('"format_version": 2,', ""), "it has no `format_version`"),
        (lambda text: text.replace('"figures"', '"numbers"', 1), "`figures`.*solve the case again"),
        (lambda text: text.replace('"value"', '"v"'), "content is not that of a result"),
        (lambda text: text.replace('"error": ', '"error": NaN, "e": ', 1), "NaN"),
    ],
)
def test_damaged_documents(change: Any, words: str, solved: tuple[ertel.Result, Path], tmp_path: Path) -> None:
    folder = copied(solved[1], tmp_path)
    path = folder / "result.json"
    path.write_text(change(path.read_text()))
    with pytest.raises(ertel.OutputError, match=words) as error:
        ertel.read(folder)
    assert str(path) in str(error.value)


def test_damaged_and_missing_files(solved: tuple[ertel.Result, Path], tmp_path: Path) -> None:
    folder = copied(solved[1], tmp_path)
    for name, get in {
        "surface.vtu": lambda r: r.pressure,
        "centreline.csv": lambda r: r.centreline,
        "report.txt": lambda r: r.report,
        "case.toml": lambda r: r.case,
    }.items():
        path = folder / name
        content = path.read_bytes()
        broken = [b"\xff\xfe" + content]
        if name in ("surface.vtu", "centreline.csv"):
            broken += [content[: len(content) // 2], content.replace(b"Points", b"Pionts").replace(b"x_m,", b"x_m,,")]
        if name == "surface.vtu":
            start = content.index(b'binary">', content.index(b"pressure_Pa"))
            broken += [content[:start] + b'binary">\nAAAA\n<' + content[start:].split(b"<", 1)[1]]
        for bytes_ in broken:
            path.write_bytes(bytes_)
            result = ertel.read(folder)
            assert isinstance(result, ertel.Result) and float(result.film_central) > 0.0
            with pytest.raises(ertel.OutputError, match=name):
                get(result)
        path.unlink()
        with pytest.raises(ertel.OutputError, match=f"{name}: the folder does not have this file"):
            get(ertel.read(folder))


def test_cases_that_name_files(line: dict[str, Any], tmp_path: Path) -> None:
    (tmp_path / "inputs").mkdir()
    (tmp_path / "inputs" / "oil.csv").write_text("pressure_MPa,temperature_degC,viscosity_mPa_s\n0,40,40\n300,40,4000\n600,40,200000\n")
    line["lubricant"]["viscosity"] = {"law": "table", "file": "oil.csv"}
    folder = ertel.Case(folder=tmp_path / "inputs", **line).solve().save(tmp_path / "out")
    result = ertel.read(folder)
    assert isinstance(result, ertel.Result) and float(result.film_central) > 0.0
    with pytest.raises(ertel.CaseError, match=r"(?s)oil\.csv.*inputs="):
        _ = result.case
    assert ertel.read(folder, inputs=tmp_path / "inputs").case.si["contact"]["kind"] == "line"
    # The same of the points of a study.
    (tmp_path / "inputs" / "line.toml").write_text(ertel.Case(folder=tmp_path / "inputs", **line).text)
    axis = [{"key": "motion.entrainment_speed", "values": ["1 m/s", "2 m/s"]}]
    ertel.sweep({"case": tmp_path / "inputs" / "line.toml", "axis": axis}, tmp_path / "study", folders=True)
    study = ertel.read(tmp_path / "study")
    assert isinstance(study, ertel.Study)
    with pytest.raises(ertel.CaseError, match=r"(?s)oil\.csv.*inputs="):
        _ = study.point(1).case
    study = ertel.read(tmp_path / "study", inputs=tmp_path / "inputs")
    assert isinstance(study, ertel.Study) and study.point(1).case.si["motion"]["entrainment_speed"] == 1.0


# Keys of version 1 as the program wrote them then: part of the document, former key, key of now.
FORMER = [
    (("summary",), "spike", "pressure_spike"),
    (("traction",), "coefficient", "traction_coefficient"),
    (("traction",), "coefficient_body_2", "traction_coefficient_body_2"),
    (("traction",), "force", "traction_force"),
    (("checks",), "load", "load_balance_error"),
    (("checks",), "mass", "film_balance_error"),
    (("checks",), "heat", "heat_balance_error"),
    (("film_reduction",), "central", "film_reduction_central"),
    (("thermal",), "film_maximum", "film_temperature_maximum"),
    (("thermal",), "film_lowest", "film_temperature_lowest"),
    (("thermal",), "body_1_maximum", "temperature_body_1_maximum"),
    (("thermal",), "body_2_mean", "temperature_body_2_mean"),
    (("thermal", "balance"), "shear", "heat_shear"),
    (("thermal", "balance"), "by_film", "heat_by_film"),
    (("thermal", "balance"), "error", "heat_balance_error"),
    (("thermal", "reduction"), "central", "thermal_reduction_central"),
    (("thermal", "reduction"), "isothermal_traction", "isothermal_traction_coefficient"),
    (("figures",), "body_1_temperature_maximum", "temperature_body_1_maximum"),
    (("figures",), "body_2_temperature_mean", "temperature_body_2_mean"),
]


def as_version_1(content: dict[str, Any]) -> int:
    """Gives a document the names of version 1; how many keys have another name."""
    n = 0
    for part, former, now in FORMER:
        place: Any = content
        for key in part:
            place = (place or {}).get(key)
        if place and now in place:
            place[former] = place.pop(now)
            n += 1
    return n


def former_columns(path: Path) -> None:
    head, rows = path.read_text().split("\n", 1)
    path.write_text(head.replace("temperature_body_1_m", "body_1_temperature_m").replace("temperature_body_2_m", "body_2_temperature_m") + "\n" + rows)


@pytest.fixture(scope="module")
def heated(cases: Path) -> ertel.Case:
    """A ball with heat on a coarse mesh."""
    text = (cases / "squalane-thermal.toml").read_text()
    return ertel.Case.from_text(text).with_({"mesh.target_error": "10 %"})


def test_results_of_version_1(heated: ertel.Case, tmp_path: Path) -> None:
    """Every part of a document, and what Python makes of it, has the names of now."""
    result = heated.solve()
    assert isinstance(result, ertel.Result)
    path = result.save(tmp_path / "heated") / "result.json"
    content = json.loads(path.read_text())
    assert content["format_version"] == 2
    content["format_version"] = 1
    assert as_version_1(content) == len(FORMER)
    path.write_text(json.dumps(content))
    again = ertel.read(path.parent)
    assert isinstance(again, ertel.Result) and again.temperature_body_1_maximum == result.temperature_body_1_maximum
    assert again.to_dict() == {**result.to_dict(), "format_version": 1}


def test_curves_of_version_1(heated: ertel.Case, tmp_path: Path) -> None:
    pytest.importorskip("pandas")
    curve = ertel.Case.from_text(f'{heated.text}\n[curve]\nquantity = "motion.entrainment_speed"\nvalues = ["1.47 m/s", "1.5 m/s"]\n').solve()
    assert isinstance(curve, ertel.Curve)
    folder = curve.save(tmp_path / "curve")
    content = json.loads((folder / "curve.json").read_text())
    content["format_version"] = 1
    assert all(as_version_1(point) > 10 for point in content["points"])
    (folder / "curve.json").write_text(json.dumps(content))
    former_columns(folder / "curve.csv")
    assert "body_1_temperature_maximum_K" in (folder / "curve.csv").read_text()
    again = ertel.read(folder)
    assert isinstance(again, ertel.Curve) and again.to_dict() == {**curve.to_dict(), "format_version": 1}
    assert again.to_pandas().equals(curve.to_pandas()) and "temperature_body_1_maximum_K" in again.to_pandas()


def test_machines_of_version_1(cases: Path, tmp_path: Path) -> None:
    text = (cases / "machine" / "fzg-c.toml").read_text()
    machine = ertel.Case.from_text(text).with_({"machine.points": 3}).solve()
    assert isinstance(machine, ertel.MachineSolution)
    folder = machine.save(tmp_path / "gears")
    content = json.loads((folder / "machine.json").read_text())
    content["format_version"] = 1
    assert sum(as_version_1(contact.get("solution", {})) for contact in content["contacts"]) > 3
    (folder / "machine.json").write_text(json.dumps(content))
    former_columns(folder / "machine.csv")
    again = ertel.read(folder)
    assert isinstance(again, ertel.MachineSolution) and again.contacts == machine.contacts
    assert again.table == machine.table and "body_1_temperature" not in again.table

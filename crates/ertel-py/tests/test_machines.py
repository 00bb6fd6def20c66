"""Whole machines, and the cases that keywords make of them."""

from __future__ import annotations

import csv
import json
import math
import os
import pickle
import re
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import ertel
from ertel import _machines

OIL = {"iso_vg": 68, "base_oil": "mineral"}


@pytest.fixture(scope="module")
def bearing() -> ertel.Bearing:
    """Five balls without clearance: both neighbours of the loaded one are alike, and the two above carry nothing."""
    return ertel.Bearing(
        "6206",
        balls=5,
        radial_clearance="0 um",
        radial_load="1 kN",
        inner_ring_speed="3000 rpm",
        bodies="steel",
        lubricant=OIL,
        temperature="70 degC",
        mesh={"target_error": 0.02},
        title="Five balls",
    )


@pytest.fixture(scope="module")
def machine(bearing: ertel.Bearing) -> ertel.MachineSolution:
    solved = ertel.solve(bearing)
    assert isinstance(solved, ertel.MachineSolution)
    return solved


def test_a_machine_is_estimated_without_a_solve(bearing: ertel.Bearing, machine: ertel.MachineSolution) -> None:
    estimate = bearing.estimate()
    for name in ("dynamic_load_rating", "kappa", "static_safety_factor", "friction_torque_skf"):
        assert estimate["figures"][name]["value"] == machine.figures[name].value
    assert estimate["not_estimated"]["friction_torque"] == "needs a solve"
    loads = [contact["load"] for contact in estimate["contacts"]]
    assert loads == [contact.load for contact in machine.contacts]
    assert "Contacts by formulas" in bearing.estimate_report()


def test_keywords_say_what_a_file_says(bearing: ertel.Bearing) -> None:
    text = """
        title = "Five balls"
        [machine]
        kind = "ball-bearing"
        designation = "6206"
        balls = 5
        radial_clearance = "0 um"
        radial_load = "1 kN"
        inner_ring_speed = "3000 rpm"
        [bodies]
        body_1 = "steel"
        body_2 = "steel"
        [lubricant]
        iso_vg = 68
        base_oil = "mineral"
        temperature = "70 degC"
        [mesh]
        target_error = 0.02
    """
    assert bearing.si == ertel.Case.from_text(text).si
    assert bearing.is_machine and not bearing.is_curve and "whole machine" in repr(bearing)
    again = pickle.loads(pickle.dumps(bearing))
    assert again == bearing and isinstance(again, ertel.Bearing)


def test_shipped_bearing_is_a_machine(cases: Path) -> None:
    assert ertel.Case.from_file(cases / "machine" / "bearing-6206.toml").is_machine
    assert not ertel.Case.from_file(cases / "machine" / "ball-bearing.toml").is_machine
    assert not ertel.Case.from_file(cases / "roller.toml").is_machine


def test_contacts(machine: ertel.MachineSolution) -> None:
    contacts = machine.contacts
    assert len(machine) == len(contacts) == 10 and machine.place_name == "angle"
    assert [c.ring for c in contacts].count("inner") == 5
    inner = {round(math.degrees(c.place)) % 360: c for c in contacts if c.ring == "inner"}
    assert sorted(inner) == [0, 72, 144, 216, 288]
    # The ball loads are in balance with 1 kN; centrifugal forces load the outer ring alone.
    assert sum(c.load * math.cos(c.place) for c in inner.values()) == pytest.approx(1000.0, rel=1e-6)
    # No clearance, hence Q ~ cos(psi)^1.5 by Hertz.
    assert inner[72].load / inner[0].load == pytest.approx(math.cos(math.radians(72.0)) ** 1.5, rel=0.02)
    assert inner[144].load == 0.0 and inner[144].solved_as is None and inner[144].figures is None
    assert inner[144].film_central is None
    # Hertz: the pressure grows with the cube root of the load.
    ratio = (inner[72].load / inner[0].load) ** (1.0 / 3.0)
    assert inner[72].hertz_pressure / inner[0].hertz_pressure == pytest.approx(ratio, rel=1e-6)
    assert inner[72].solved_as == inner[288].solved_as and inner[72].figures is inner[288].figures
    assert inner[0].film_central == inner[0].figure("film_central") != inner[72].film_central
    with pytest.raises(KeyError, match="film_central"):
        inner[0].figure("film")
    with pytest.raises(AttributeError, match="no attribute"):
        _ = inner[0].film
    assert machine.governing_contact is inner[0] and machine.governing_contact.name == "ball 0, inner ring"


def test_figures(machine: ertel.MachineSolution) -> None:
    torque = machine.figures["friction_torque"]
    assert isinstance(torque, ertel.MachineFigure) and torque.unit == "N m" and torque.words and torque.value > 0.0
    assert machine.friction_torque is torque is machine.figure("friction_torque")
    assert machine.figure("torque") is None
    with pytest.raises(AttributeError, match="friction_torque"):
        _ = machine.torque
    with pytest.raises(AttributeError, match="no attribute"):
        _ = machine._figure
    smallest = min(float(c.film_minimum) for c in machine.contacts if c.film_minimum is not None)
    assert float(machine.film_minimum) == smallest and machine.film_minimum.error > 0.0
    assert "film_minimum" in dir(machine)
    assert not machine.failed and machine.failures == []
    assert all(isinstance(warning, str) for warning in machine.warnings)
    assert len(machine.warning_codes) == len(machine.warnings)
    assert all("meaning" in ertel.explain(code) for code in machine.warning_codes)
    assert "friction torque" in machine.report and "ball 0, inner ring" in machine.report
    assert "10 contacts" in repr(machine) and "<table>" in machine._repr_html_()


def test_marks_reach_totals() -> None:
    """Newtonian oil under spin transmits friction that no lubricant does: the totals carry it, the films do not."""
    solved = ertel.solve(
        ertel.Bearing(
            "6206",
            balls=5,
            axial_load="3 kN",
            inner_ring_speed="1000 rpm",
            bodies="steel",
            lubricant={
                "density": {"law": "constant", "rho_0": "850 kg/m^3"},
                "viscosity": {"law": "roelands", "mu_0": "17 mPa.s", "alpha": "18 1/GPa"},
            },
            temperature="70 degC",
            mesh={"target_error": 0.1},
        )
    )
    assert isinstance(solved, ertel.MachineSolution)
    for name in ("friction_power_spin", "friction_power", "friction_torque"):
        figure = solved.figures[name]
        assert figure.doubtful and figure.marks == ("friction-beyond-lubricants",), name
    assert not solved.film_minimum.doubtful and solved.film_minimum.marks == ()


def test_courses_and_shaft(machine: ertel.MachineSolution) -> None:
    loads = machine.contact_figures["element_load"]
    assert loads.unit == "N" and loads.contact == list(range(len(machine))) and loads.place == [c.place for c in machine.contacts]
    assert loads.value == pytest.approx([c.load for c in machine.contacts])
    shaft = machine.shaft
    assert shaft is not None and len(shaft.displacement) == len(shaft.load) == len(shaft.stiffness) == 5
    # The stiffness of an elastic bearing is symmetric.
    assert shaft.stiffness[0][2] == pytest.approx(shaft.stiffness[2][0], rel=1e-6, abs=1.0)


def test_tables(machine: ertel.MachineSolution) -> None:
    pytest.importorskip("pandas")
    rows = machine.to_pandas()
    assert len(rows) == 10 and list(rows["name"]) == [c.name for c in machine.contacts]
    assert set(machine.table.splitlines()[0].split(",")) <= set(rows.columns)
    films = [c.film_central.value if c.film_central else math.nan for c in machine.contacts]
    assert rows["film_central_m"].tolist() == pytest.approx(films, rel=1e-6, nan_ok=True)


GEARS = {
    "template": "FZG-C14",
    "pinion_torque": "100 N.m",
    "pinion_speed": "1500 rpm",
    "position": "path",
    "points": 3,
    "bodies": "steel",
    "lubricant": OIL,
    "temperature": "90 degC",
    "mesh": {"preset": "coarse"},
    "solver": {"newtonian": True},
}


def test_points_of_a_curve_are_machines() -> None:
    pytest.importorskip("pandas")
    curve = {"quantity": "machine.pinion_torque", "values": ["100 N.m", "110 N.m"]}
    solved = ertel.solve(ertel.GearPair(**GEARS, curve=curve))
    assert isinstance(solved, ertel.Curve) and solved.failures == []
    rows = solved.to_pandas()
    alone = ertel.solve(ertel.GearPair(**GEARS))
    assert isinstance(alone, ertel.MachineSolution)
    assert rows["friction_power_W"][0] == pytest.approx(float(alone.friction_power), rel=1e-6)
    assert (rows["mesh_loss"] > 0.0).all() and (rows["mesh_loss_error"] > 0.0).all()


def test_the_program_says_the_same(machine: ertel.MachineSolution, program: str, tmp_path: Path) -> None:
    path = tmp_path / "bearing.toml"
    path.write_text(machine.case.text)
    subprocess.run([program, "solve", path, "--output", tmp_path / "own", "--quiet", "--accept-unresolved"], check=True)
    machine.save(tmp_path / "python")
    for name in ["case.toml", "around.svg"]:
        own, python = tmp_path / "own" / name, tmp_path / "python" / name
        assert own.read_bytes() == python.read_bytes(), name

    def rows(folder: str) -> list[list[str]]:
        """The table without times."""
        table = list(csv.reader((tmp_path / folder / "machine.csv").open(encoding="utf-8", newline="")))
        kept = [i for i, title in enumerate(table[0]) if "second" not in title and not title.endswith("_s")]
        return [[row[i] for i in kept] for row in table]

    assert rows("own") == rows("python") and len(rows("own")) == 11
    document = json.loads((tmp_path / "own" / "machine.json").read_text())
    assert document["figures"] == machine.to_dict()["figures"] and document["warnings"] == machine.warnings
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "thesis.txt").write_text("precious")
    with pytest.raises(ertel.OutputError):
        machine.save(tmp_path / "mine")
    kept = pickle.loads(pickle.dumps(machine))
    assert kept.figures == machine.figures and kept.contacts == machine.contacts and kept.report == machine.report
    with pytest.raises(RuntimeError, match="pickled"):
        kept.save(tmp_path / "kept")


def test_events_and_starts(bearing: ertel.Bearing, line: dict[str, Any]) -> None:
    def stop(event: dict[str, Any]) -> None:
        raise LookupError(event["label"])

    with pytest.raises(LookupError, match="ball . inner|ball ., "):
        bearing.solve(progress=stop)
    other = ertel.Case(**line).solve()
    assert isinstance(other, ertel.Result)
    with pytest.raises(ertel.CaseError, match="leave out `start`"):
        bearing.solve(start=other)


@pytest.mark.skipif(os.name != "posix", reason="signals")
def test_interrupt(cases: Path, interrupted: Callable[[str, float], None]) -> None:
    interrupted(
        f"text = open({str(cases / 'machine' / 'bearing-6206.toml')!r}).read()\n"
        # Long enough for the signal.
        "case = ertel.Case.from_text(text.replace('target_error = 0.01', 'target_error = 0.0005'))\n",
        20.0,
    )


def test_rollers_by_designation_dimensions_or_kind() -> None:
    keys: dict[str, Any] = {"bodies": "steel", "lubricant": OIL, "temperature": "70 degC"}
    loads = {"radial_load": "2 kN", "inner_ring_speed": "3000 rpm"}
    kinds = {
        "NU 206": "roller-bearing",
        " nu206": "roller-bearing",
        "6206": "ball-bearing",
        "7206 B": "ball-bearing",
    }
    for designation, kind in kinds.items():
        # An angular contact bearing needs an axial load.
        all_loads = loads | ({"axial_load": "2 kN"} if designation.endswith("B") else {})
        # The designation says the kind.
        assert "kind" not in ertel.Bearing(designation, **all_loads, **keys).given["machine"], designation
        assert ertel.Bearing(designation, kind=kind, **all_loads, **keys).is_machine, designation
    rollers = {"rollers": 12, "roller_diameter": "9 mm", "roller_length": "9 mm", "pitch_diameter": "46.5 mm", "radial_clearance": "20 um"}
    assert ertel.Bearing(**rollers, **loads, **keys).given["machine"]["kind"] == "roller-bearing"
    with pytest.raises(ertel.CaseError, match="6206 has balls"):
        ertel.Bearing("6206", kind="roller-bearing", **loads, **keys)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"designation": "6999"}, "no bearing `6999` in the catalogue(.|\n)*nearest"),
        ({"radial_lode": "2 kN"}, "unknown key(.|\n)*radial_load"),
        ({"radial_load": "2 mm"}, "radial_load"),
        ({"kind": "needle-bearing"}, "ball-bearing"),
        ({"inner_ring_speed": None}, "inner_ring_speed"),
        ({"bodies": "wood"}, "wood"),
        ({"lubricant": {"iso_vg": 68, "base": "mineral"}}, "base_oil"),
        ({"temperature": None}, "temperature"),
        ({"mesh": {"target": 0.02}}, "target_error"),
    ],
)
def test_bad_keywords_are_reported_as_in_a_file(changes: dict[str, Any], words: str) -> None:
    keys: dict[str, Any] = {
        "designation": "6206",
        "radial_load": "2 kN",
        "inner_ring_speed": "3000 rpm",
        "bodies": "steel",
        "lubricant": OIL,
        "temperature": "70 degC",
    }
    with pytest.raises(ertel.CaseError, match=words):
        ertel.Bearing(**{**keys, **changes})


@pytest.mark.parametrize(("make", "name"), [(ertel.GearPair, "spur-gear"), (ertel.GearPair, "helical-gear"), (ertel.Cam, "cam-and-flat-tappet")])
def test_gears_and_cams(make: type[ertel.Case], name: str, cases: Path) -> None:
    """The keys of the shipped files as keywords."""
    shipped = ertel.Case.from_file(cases / "machine" / f"{name}.toml")
    given = shipped.given
    made = make(**given.pop("machine"), **given)
    assert made.si == shipped.si
    with pytest.raises(ertel.CaseError, match="unknown key"):
        make(**{**shipped.given.pop("machine"), "teeth": 20}, **given)


def test_a_lubricant_by_name(line: dict[str, Any]) -> None:
    keys: dict[str, Any] = {"radial_load": "2 kN", "inner_ring_speed": "3000 rpm", "bodies": {"body_1": "steel", "body_2": "silicon-nitride"}}
    case = ertel.Bearing("6206", lubricant="squalane-pip", temperature="70 degC", **keys)
    assert case.given["lubricant"] == "squalane-pip" and case.inputs["temperature"] == pytest.approx(343.15)


def test_sections_are_those_of_the_reference(root: Path) -> None:
    text = (root / "docs/reference/case-file.md").read_text(encoding="utf-8")
    table = text.split("<!-- generated: sections -->")[1].split("<!-- end -->")[0]
    sections = set(re.findall(r"^\| `(\w+)` \|", table, re.MULTILINE))
    # The figures of a machine instead.
    assert set(_machines._SECTIONS) == sections - {"machine", "contact", "motion"}

"""Values that are no values of a case, and arguments of no function: each refused by an error of the package, none by the interpreter."""

from __future__ import annotations

import os
import tomllib
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ertel
from ertel import _toml

CASE: dict[str, Any] = {
    "contact": {"kind": "line", "radius": "10 mm", "load": "100 kN/m"},
    "bodies": {"body_1": "steel", "body_2": "steel"},
    "motion": {"entrainment_speed": "2 m/s", "slide_to_roll_ratio": 0.0},
    "lubricant": "squalane-pip",
    "temperature": "40 degC",
}


@pytest.mark.parametrize("title", ["oil \U0001f600", "µ ≤ 𝜇", 'a "b" \\ c\n\t\b\f', "\x00\x1f\x7f\x80", "", "\u2028"])
def test_every_text_is_read_as_it_is(title: str) -> None:
    assert ertel.Case(title=title, **CASE).title == title
    assert tomllib.loads(_toml.text({"a": {title: [title, {title: title}]}})) == {"a": {title: [title, {title: title}]}}


def test_values_of_numpy_are_those_of_python() -> None:
    values = {
        "truth": np.True_,
        "array": np.array([True, False]),
        "scalar": np.array(False),
        "whole": np.int64(3),
        "number": np.float32(0.5),
        "text": np.str_("16 mm"),
        "fraction": Fraction(1, 4),
    }
    expected = {
        "truth": True,
        "array": [True, False],
        "scalar": False,
        "whole": 3,
        "number": 0.5,
        "text": "16 mm",
        "fraction": 0.25,
    }
    read = tomllib.loads(_toml.text(values))
    assert read == expected
    assert [type(read[key]) for key in expected] == [type(value) for value in expected.values()]


def _endless() -> list[Any]:
    values: list[Any] = []
    values.append(values)
    return values


def _endless_mapping() -> dict[str, Any]:
    values: dict[str, Any] = {}
    values["again"] = values
    return values


@pytest.mark.parametrize(
    "value",
    [
        "\ud800",
        {"\ud800": 1},
        b"10 mm",
        1 + 2j,
        {1, 2},
        10**5000,
        Fraction(10**400),
        range(10**12),
        _endless(),
        _endless_mapping(),
        np.zeros(2_000_000),
        np.datetime64("2026-01-01"),
        [None],
        object(),
        Path,
        int,
    ],
    ids=lambda value: type(value).__name__,
)
def test_what_is_no_value_is_a_case_error(value: Any) -> None:
    with pytest.raises(ertel.CaseError):
        ertel.Case(**{**CASE, "title": value})


def test_quantities_of_pint_that_are_no_number() -> None:
    pint = pytest.importorskip("pint")
    units = pint.UnitRegistry()
    with pytest.raises(ertel.CaseError, match="contact.radius"):
        ertel.Case(**{**CASE, "contact": {**CASE["contact"], "radius": np.array([1.0, 2.0]) * units.mm}})


@pytest.mark.parametrize(
    "arguments",
    [
        {"n_points": 1},
        {"n_points": 2.5},
        {"n_points": 40_000_000},
        {"n_points": 10**400},
        {"extent": (0.0, 0.0, 0.0, 0.0)},
        {"extent": (0.0, 1.0)},
        {"extent": (0.0, float("nan"), 0.0, 1.0)},
        {"extent": "wide"},
        {"extent": (1.0, 0.0, 0.0, 1.0)},
    ],
    ids=str,
)
def test_grids_that_cannot_be(arguments: dict[str, Any], line: ertel.Result) -> None:
    with pytest.raises(ertel.CaseError):
        line.to_xarray(**arguments)


@pytest.fixture(scope="module")
def line() -> ertel.Result:
    result = ertel.Case(**CASE).solve()
    assert isinstance(result, ertel.Result)
    return result


def test_wrong_arguments_are_case_errors(line: ertel.Result, tmp_path: Path) -> None:
    table = tmp_path / "states.csv"
    table.write_text("pressure_MPa,temperature_degC,viscosity_mPa_s\n0,40,40\n100,40,200\n")
    wrong: Any
    for wrong in (
        lambda: ertel.viscosity("squalane-pip", "much", 313.0),
        lambda: ertel.viscosity("squalane-pip", 1e8, "40 degC"),
        lambda: ertel.fit_viscosity(table, "barus", hold={"mu_0": 0.04}),
        lambda: ertel.fit_film(table, radius="10 mm"),
        lambda: ertel.sweep({"case": 5}, tmp_path / "out"),
        lambda: ertel.Case(**CASE).solve(start=3),
        lambda: ertel.Case(**CASE).solve(progress=3),
    ):
        with pytest.raises(ertel.CaseError):
            wrong()


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes")
def test_tables_are_regular_files(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    for path in (pipe, Path("/dev/zero"), tmp_path, tmp_path / "missing.csv"):
        for fit in (
            lambda path=path: ertel.fit_viscosity(path, "barus"),
            lambda path=path: ertel.fit_density(path, "tait"),
            lambda path=path: ertel.fit_film(path),
        ):
            with pytest.raises(ertel.CaseError, match="cannot be read"):
                fit()


def test_an_entry_replaces_nothing(tmp_path: Path) -> None:
    fit = ertel.Fit({}, {}, 0.0, [], "title = 'mine'\n")
    path = fit.save(tmp_path / "mine.toml")
    with pytest.raises(ertel.OutputError, match=r"mine\.toml"):
        fit.save(path)

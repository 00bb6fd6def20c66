"""Laws that are functions of Python."""

from __future__ import annotations

import math
import pickle
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ertel


def barus(pressure: float, temperature: float) -> float:
    return 0.04 * math.exp(2e-8 * pressure - 0.03 * (temperature - 313.15))


def dowson_higginson(pressure: float, temperature: float) -> float:
    return 870.0 * (1.0 + 0.6e-9 * pressure / (1.0 + 1.7e-9 * pressure))


def solve(case: ertel.Case) -> ertel.Result:
    result = case.solve()
    assert isinstance(result, ertel.Result)
    return result


def test_a_function_is_the_law_that_it_says(line: dict[str, Any], tmp_path: Path) -> None:
    """Films by the functions of Barus and of Dowson and Higginson, and by the laws of these names."""
    line["lubricant"]["viscosity"] = {"law": "barus", "mu_0": "40 mPa.s", "alpha": "20 1/GPa"}
    known = ertel.Case(**line)
    case = known.with_law("viscosity", barus).with_law("density", dowson_higginson)
    assert set(case.tabulated) == {"viscosity", "density"} and "# lubricant.viscosity: table of a Python function" in case.text
    for law in case.tabulated.values():
        assert 0.0 < law.error <= 1e-4 and law.pressures == (0.0, 2.0 * known.estimate()["hertz"]["pressure"])
        assert law.temperatures == pytest.approx((293.15, 413.15))
    film, expected = solve(case).film_central, solve(known).film_central
    assert float(film) == pytest.approx(float(expected), rel=3e-4)
    assert pickle.loads(pickle.dumps(case)).tabulated == case.tabulated
    assert set(case.with_({"contact.load": "50 kN/m"}).tabulated) == {"viscosity", "density"}
    assert set(case.with_({"lubricant.density": line["lubricant"]["density"]}).tabulated) == {"viscosity"}
    again = ertel.read(solve(case).save(tmp_path / "out"))
    assert isinstance(again, ertel.Result) and again.case.text == case.text


def test_the_bound_holds(line: dict[str, Any]) -> None:
    """At places that were not looked at, against the function itself."""

    def hilly(pressure: float, temperature: float) -> float:
        return barus(pressure, temperature) * (1.0 + 0.2 * math.sin(pressure / 60e6) * math.cos(temperature / 9.0))

    law = ertel.Case(**line).with_law("viscosity", hilly, tolerance=1e-2).tabulated["viscosity"]
    from ertel import _ertel

    p, t = np.linspace(*law.pressures, law.n_pressures), np.linspace(*law.temperatures, law.n_temperatures)
    rows = [[hilly(a, b) for a in p.tolist()] for b in t.tolist()]
    random = np.random.default_rng(1)
    places = list(zip(random.uniform(*law.pressures, 4000).tolist(), random.uniform(*law.temperatures, 4000).tolist()))
    found = np.array(_ertel.interpolated(True, t.tolist(), p.tolist(), rows, places))
    away = np.abs(found / np.array([hilly(*place) for place in places]) - 1.0).max()
    assert 0.05 * law.error < away <= law.error <= 1e-2


@pytest.mark.parametrize(
    ("law", "words"),
    [
        (lambda p, t: float("nan"), "viscosity at 0 MPa.*finite number above zero"),
        (lambda p, t: 0.04 if p < 3e8 else math.inf, "MPa and 293.15 K is inf"),
        (lambda p, t: 0.04 - 1e-10 * p, "above zero"),
        (lambda p, t: 0.04 if p < 3e8 else 0.05, r"not smooth enough: near \d+"),
        (lambda p, t: 0.04 if t < 321.0 else 0.05, "not smooth enough"),
        (lambda p, t: "much", "'much', not one number"),
        (0.04, "a function of pressure"),
    ],
)
def test_functions_that_are_no_law(law: Any, words: str, line: dict[str, Any]) -> None:
    with pytest.raises(ertel.CaseError, match=words):
        ertel.Case(**line).with_law("viscosity", law)


def test_a_law_in_its_place_leaves_nothing_behind(line: dict[str, Any]) -> None:
    """Neither what was said of the function nor its error; one note after a second function."""
    case = ertel.Case(**line).with_law("viscosity", barus)
    own = {"law": "barus", "mu_0": "40 mPa.s", "alpha": "20 1/GPa"}
    other = case.with_({"lubricant.viscosity": own})
    assert not other.tabulated and "Python function" not in other.text
    kept = case.with_({"motion.entrainment_speed": "1 m/s"})
    assert kept.tabulated.keys() == {"viscosity"} and "Python function" in kept.text
    assert case.with_law("viscosity", barus, tolerance=1e-3).text.count("Python function") == 1


def test_a_case_beyond_the_table_warns(line: dict[str, Any]) -> None:
    """A line contact under 16 times the load has four times the Hertz pressure, and the table ends at twice the first one."""
    case = ertel.Case(**line).with_law("viscosity", barus)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        case.with_({"contact.load": "300 kN/m"})
    with pytest.warns(ertel.ErtelWarning, match="viscosity was tabulated for another case: the Hertz pressure is .* GPa, the table ends"):
        heavy = case.with_({"contact.load": "1600 kN/m"})
    with pytest.warns(ertel.ErtelWarning, match="the lubricant has 433.15 K"):
        case.with_({"lubricant.temperature": "160 degC"})
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        again = heavy.with_law("viscosity", barus)
    assert again.tabulated["viscosity"].pressures[1] == 2.0 * heavy.estimate()["hertz"]["pressure"]


def test_ranges_and_names(line: dict[str, Any]) -> None:
    case = ertel.Case(**line)
    for arguments, words in [
        ({"pressures": (1.0, 0.0)}, "pressures"),
        ({"temperatures": (0.0, 300.0)}, "temperatures"),
        ({"tolerance": 0.0}, "tolerance"),
        ({"tolerance": "x"}, "tolerance"),
        ({"pressures": (1.0,)}, "pressures"),
        ({"temperatures": ("a", 300.0)}, "temperatures"),
    ]:
        with pytest.raises(ertel.CaseError, match=words):
            case.with_law("viscosity", barus, **arguments)
    with pytest.raises(ertel.CaseError, match="viscosity or density"):
        case.with_law("conductivity", barus)  # type: ignore[arg-type]
    with pytest.raises(LookupError, match="own"):
        case.with_law("viscosity", lambda p, t: (_ for _ in ()).throw(LookupError("own")))

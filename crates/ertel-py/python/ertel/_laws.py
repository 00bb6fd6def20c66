"""Laws of a lubricant that are functions of Python: tables of them, fine enough."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _ertel
from ._ertel import CaseError

Law = Callable[[float, float], float]
Floats = NDArray[np.float64]

UNITS = {"viscosity": "Pa.s", "density": "kg/m^3"}

# Knots to begin with, and at most.
_FIRST = (33, 5)
_MOST = (513, 33)
# Places within an interval where the table is compared with the function, and what the largest difference there is multiplied with.
_WITHIN = (0.25, 0.5, 0.75)
_SAFETY = 2.0


class ErtelWarning(UserWarning):
    """Warning about values outside the range of a table or law."""


@dataclass(frozen=True)
class TabulatedLaw:
    """A law of a case that is the table of a function.

    Attributes
    ----------
    pressures : tuple of float
        Limits of the table, Pa above ambient; beyond them it is extrapolated linearly (of a viscosity its logarithm).
    temperatures : tuple of float
        Limits of the table, K.
    n_pressures, n_temperatures : int
        Its knots.
    error : float
        Estimate of the interpolation error, relative: twice the largest difference found within the intervals.
    """

    pressures: tuple[float, float]
    temperatures: tuple[float, float]
    n_pressures: int
    n_temperatures: int
    error: float

    def __str__(self) -> str:
        low, high = (p * 1e-9 for p in self.pressures)
        return (
            f"table of a Python function at {self.n_pressures} pressures from {low:.4g} to {high:.4g} GPa and {self.n_temperatures} "
            f"temperatures from {self.temperatures[0]:.5g} to {self.temperatures[1]:.5g} K, interpolation error below {self.error:.1e}"
        )


def tabulated(
    name: str, law: Law, pressures: tuple[float, float], temperatures: tuple[float, float], tolerance: float
) -> tuple[dict[str, Any], TabulatedLaw]:
    """The table of a case file, refined until its error is below `tolerance`."""
    for what, limits in {"pressures": pressures, "temperatures": temperatures}.items():
        try:
            low, high = (float(limit) for limit in limits)
        except (TypeError, ValueError):
            raise CaseError(f"{what} = {limits!r}: two numbers in SI, the first one below the second") from None
        if not (math.isfinite(low) and math.isfinite(high) and low < high and (what == "pressures" or low > 0.0)):
            raise CaseError(f"{what} = ({low!r}, {high!r}): two numbers in SI, the first one below the second")
    if not isinstance(tolerance, (int, float)) or not 0.0 < tolerance < 1.0:
        raise CaseError(f"tolerance = {tolerance!r}: a number between 0 and 1")
    n = list(_FIRST)
    known: dict[tuple[float, float], float] = {}

    def value(p: float, t: float) -> float:
        if (p, t) not in known:
            known[p, t] = _checked(name, law, p, t)
        return known[p, t]

    while True:
        p, t = np.linspace(*pressures, n[0]), np.linspace(*temperatures, n[1])
        rows = [[value(float(own_p), float(own_t)) for own_p in p] for own_t in t]
        # Between the knots along either axis, and in the middles of the cells.
        along_p = [(q, own_t) for q in _between(p) for own_t in t]
        along_t = [(own_p, s) for s in _between(t) for own_p in p[:: max(1, n[0] // 32)]]
        inner = [(q, s) for s in 0.5 * (t[1:] + t[:-1]) for q in 0.5 * (p[1:] + p[:-1])]
        errors = []
        for places in (along_p, along_t, inner):
            at = [(float(q), float(s)) for q, s in places]
            found = np.array(_ertel.interpolated(name == "viscosity", t.tolist(), p.tolist(), rows, at))
            errors.append(np.abs(found / np.array([value(*place) for place in at]) - 1.0))
        worst = [_SAFETY * float(e.max()) for e in errors]
        if max(worst) <= tolerance:
            break
        grow = [worst[0] > 0.4 * tolerance, worst[1] > 0.4 * tolerance]
        if not any(grow):
            grow = [True, True]
        finer = _finer(n, grow)
        if finer == n:
            finer = _finer(n, [True, True])
        # An axis at its largest size fails if its own error exceeds the tolerance.
        if finer == n or any(own >= most and error > tolerance for own, most, error in zip(n, _MOST, worst)):
            places = (along_p, along_t, inner)[int(np.argmax(worst))]
            q, s = places[int(np.argmax(errors[int(np.argmax(worst))]))]
            raise CaseError(
                f"the {name} is not smooth enough: near {q * 1e-6:.5g} MPa and {s:.5g} K a table of {n[0]} pressures and {n[1]} temperatures "
                f"errs by {max(worst):.1e}, more than the tolerance {tolerance:.1e}; smooth its kinks and steps, or raise `tolerance`"
            )
        n = finer
    isotherms = [
        {"temperature": f"{own_t!r} K", "pressure": p.tolist(), name: row} for own_t, row in zip(t.tolist(), rows)
    ]
    table = {"law": "table", "units": {"pressure": "Pa", name: UNITS[name]}, "isotherms": isotherms}
    return table, TabulatedLaw(pressures, temperatures, n[0], n[1], max(worst))


def _finer(n: list[int], grow: list[bool]) -> list[int]:
    return [min(2 * own - 1, most) if wanted else own for own, most, wanted in zip(n, _MOST, grow)]


def _between(knots: Floats) -> Floats:
    return np.concatenate([knots[:-1] + share * np.diff(knots) for share in _WITHIN])


def _checked(name: str, law: Law, p: float, t: float) -> float:
    found = law(p, t)
    try:
        number = float(found)
    except (TypeError, ValueError, OverflowError):
        raise CaseError(f"the {name} at {p!r} Pa and {t!r} K is {found!r}, not one number in {UNITS[name]}") from None
    if not (math.isfinite(number) and number > 0.0):
        raise CaseError(
            f"the {name} at {p * 1e-6:.5g} MPa and {t:.5g} K is {number!r}: a finite number above zero in {UNITS[name]}, wherever the table is; "
            "give `pressures` and `temperatures` where the function holds"
        )
    return number

"""Figures with their bars."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from . import _ertel


@dataclass(frozen=True)
class Quantity:
    """A figure with its bars, in SI; ``float(quantity)`` is its value.

    Attributes
    ----------
    value : float
        On the finest mesh.
    error : float or None
        Half-width of the discretisation error bar.
    uncertainty : float or None
        Half-width that the uncertainty of the inputs makes, two standard deviations; None where they have none.
    unit : str
        SI unit, empty for a pure number.
    resolved : bool
        False where the error bar is too wide for a number, more than half of it or a tenth of a largest pressure; a largest pressure
        is a lower bound then.
    place : tuple of float or None
        Where it is, (x, y) in m; None of figures that belong to the whole contact.
    """

    value: float
    error: float | None = None
    uncertainty: float | None = None
    unit: str = ""
    resolved: bool = True
    place: tuple[float, float] | None = None

    def __float__(self) -> float:
        return self.value

    def to_pint(self, registry: Any = None) -> Any:
        """The value as a quantity of pint; needs pint.

        Parameters
        ----------
        registry : pint.UnitRegistry, optional
            The registry to which it shall belong, by default pint's application registry.
        """
        import pint

        units = pint.get_application_registry() if registry is None else registry
        # Units such as "N m" and "W/m" are products for pint, too.
        return units.Quantity(self.value, self.unit.replace(" ", "*") or "dimensionless")

    def __str__(self) -> str:
        factor, unit = 1.0, self.unit
        size = abs(self.value)
        if unit in ("m", "Pa", "N", "W") and size > 0.0:
            for scale, prefix in _PREFIXES:
                if size >= scale * 0.9995:
                    factor, unit = 1.0 / scale, prefix + unit
                    break
        text = _with_bar(self.value * factor, None if self.error is None else self.error * factor)
        text += f" {unit}".rstrip()
        if not self.resolved:
            text = f"not resolved ({text})"
        if self.uncertainty is not None:
            text += f" (inputs ± {self.uncertainty * factor:.2g})"
        return text

    __repr__ = __str__


# Most digits of a value, and, as the program prints, the first three digits of a bar up to which two of them are shown.
_MOST_DIGITS = 7
_TWO_DIGITS_UP_TO = 354


def _with_bar(value: float, error: float | None) -> str:
    """A number with the digits that its error bar leaves certain."""
    if error is None:
        return f"{value:.5g}"
    size = max(abs(value), error)
    if not 0.0 < error < math.inf or not 1e-4 <= size < 1e9:
        return f"{value:.5g} ± {error:.2g}"
    first = math.floor(math.log10(error))
    decimals = (1 if round(error * 10.0 ** (2 - first)) <= _TWO_DIGITS_UP_TO else 0) - first
    decimals = min(decimals, _MOST_DIGITS - 1 - math.floor(math.log10(size)))
    shown = [f"{round(number, decimals):.{max(decimals, 0)}f}" for number in (value, max(error, 10.0**-decimals))]
    return " ± ".join(shown)


_PREFIXES = ((1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n"))

# Words and symbol of each figure; those with a symbol are shown first.
_FIGURE_NAMES: dict[str, tuple[str, str]] = {name: (words, symbol) for name, words, symbol in _ertel.figure_names()}

_FIELD_NAMES: dict[str, tuple[str, str]] = {name: (unit, words) for name, unit, words in _ertel.field_names()}


def _read(entry: dict[str, Any], uncertainty: float | None = None) -> Quantity:
    """A figure as JSON has it."""
    place = (entry["x"], entry["y"]) if "x" in entry else None
    return Quantity(entry["value"], entry["error"], uncertainty, entry["unit"], entry["resolved"] is not False, place)

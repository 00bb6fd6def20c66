"""Names of version 1 of the layout, which are read under those of now."""

from __future__ import annotations

import re
from typing import Any

# Temperatures of the bodies, wherever they are keys or begin one.
_TEMPERATURE = re.compile(r"body_([12])_temperature_(maximum|mean)")
# Units of version 1 have the names of parts as keys.
_UNITS = {f"{what}": f"film_temperature_{part}" for what, part in (("film_maximum", "maximum"), ("film_lowest", "lowest"), ("film_mean", "mean"))}
_UNITS |= {f"body_{n}_{part}": f"temperature_body_{n}_{part}" for n in (1, 2) for part in ("maximum", "mean")}

_TRACTION = {
    "coefficient": "traction_coefficient",
    "coefficient_body_1": "traction_coefficient_body_1",
    "coefficient_body_2": "traction_coefficient_body_2",
    "force": "traction_force",
    "moment": "traction_moment",
}
# Keys within a part, by the name of the part.
_WITHIN: dict[str, dict[str, str]] = {
    "summary": {"spike": "pressure_spike"},
    "traction": _TRACTION,
    "across": {
        "coefficient": "traction_coefficient_across",
        "coefficient_body_1": "traction_coefficient_across_body_1",
        "coefficient_body_2": "traction_coefficient_across_body_2",
        "force": "traction_force_across",
    },
    "checks": {"load": "load_balance_error", "mass": "film_balance_error", "heat": "heat_balance_error"},
    "film_reduction": {"central": "film_reduction_central", "minimum": "film_reduction_minimum"},
    "starvation": {"ratio_central": "starved_ratio_central", "ratio_minimum": "starved_ratio_minimum"},
    "thermal": _UNITS,
    "balance": {
        "shear": "heat_shear",
        "compression": "heat_compression",
        "to_body_1": "heat_to_body_1",
        "to_body_2": "heat_to_body_2",
        "by_film": "heat_by_film",
        "error": "heat_balance_error",
    },
    "reduction": {
        "central": "thermal_reduction_central",
        "minimum": "thermal_reduction_minimum",
        "traction": "thermal_reduction_traction",
        "isothermal_traction": "isothermal_traction_coefficient",
    },
    "formulas": {"central": "film_central", "minimum": "film_minimum"},
    "units": _UNITS,
}
# Texts of users stay as they are.
_LEFT = ("case",)


def with_new_names(content: Any, part: str = "") -> Any:
    """A document of version 1 with the names of now.

    Parameters
    ----------
    content
        The document, or a part of it.
    part : str
        Its key in the document, empty for the whole.
    """
    if isinstance(content, list):
        return [with_new_names(value, part) for value in content]
    if not isinstance(content, dict) or part in _LEFT:
        return content
    names: dict[str, str] = _WITHIN.get(part, {})
    return {_TEMPERATURE.sub(r"temperature_body_\1_\2", names.get(key, str(key))): with_new_names(value, key) for key, value in content.items()}


def with_new_columns(table: str) -> str:
    """A table of version 1 with the names of now in its first line."""
    head, end, rows = table.partition("\n")
    return _TEMPERATURE.sub(r"temperature_body_\1_\2", head) + end + rows

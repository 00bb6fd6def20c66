"""Keywords of Python as the text of a case file."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from typing import Any

from ._ertel import CaseError


def text(sections: Mapping[str, Any]) -> str:
    """The case file that says what nested mappings say, one key a line."""
    lines: list[str] = []
    for key, value in sections.items():
        _lines([str(key)], value, lines)
    return "".join(line + "\n" for line in lines)


def _lines(path: list[str], value: Any, lines: list[str]) -> None:
    if isinstance(value, Mapping):
        if not value:
            lines.append(f"{_path(path)} = {{}}")
        for key, inner in value.items():
            _lines([*path, str(key)], inner, lines)
    elif value is not None:
        lines.append(f"{_path(path)} = {_value(path, value)}")


def _path(path: list[str]) -> str:
    return ".".join(_key(key) for key in path)


def _key(key: str) -> str:
    bare = key and all(c.isascii() and (c.isalnum() or c in "_-") for c in key)
    return key if bare else json.dumps(key)


def _value(path: list[str], value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value)
    if hasattr(value, "magnitude") and hasattr(value, "units"):
        return json.dumps(_quantity(value))
    if isinstance(value, Mapping):
        inner = (f"{_key(str(k))} = {_value([*path, str(k)], v)}" for k, v in value.items())
        return "{ " + ", ".join(inner) + " }"
    if hasattr(value, "__index__"):
        return str(value.__index__())
    if hasattr(value, "__float__"):
        number = float(value)
        if math.isnan(number):
            return "nan"
        if math.isinf(number):
            return "inf" if number > 0 else "-inf"
        return repr(number)
    if isinstance(value, Sequence) or hasattr(value, "tolist"):
        values = value.tolist() if hasattr(value, "tolist") else value
        return "[" + ", ".join(_value(path, v) for v in values) + "]"
    if hasattr(value, "__fspath__"):
        return json.dumps(value.__fspath__())
    raise CaseError(
        f"`{'.'.join(path)}`: a {type(value).__name__} is no value of a case; "
        "give a string with a unit, a pint quantity, a number, a list or a mapping"
    )


def _quantity(value: Any) -> str:
    """A quantity of pint in SI base units, whose dimension the reader checks."""
    base = value.to_base_units()
    parts = []
    for unit, power in base.unit_items():
        symbol = _BASE_UNITS.get(str(unit))
        if symbol is None or float(power) != int(power):
            raise CaseError(f"`{value}`: its unit is not known to ertel; give a string such as \"16 mm\"")
        parts.append((symbol, int(power)))
    over = [_power(s, p) for s, p in parts if p > 0]
    under = [_power(s, -p) for s, p in parts if p < 0]
    unit = ".".join(over) or ("1" if under else "")
    for part in under:
        unit += "/" + part
    return f"{float(base.magnitude)!r} {unit}".strip()


_BASE_UNITS = {"meter": "m", "kilogram": "kg", "second": "s", "kelvin": "K", "radian": "rad"}


def _power(symbol: str, power: int) -> str:
    return symbol if power == 1 else f"{symbol}^{power}"

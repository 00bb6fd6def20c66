"""Keywords of Python as the text of a case file."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from typing import Any

from ._ertel import CaseError


# Deeper nesting and longer lists are in no case: they are mistakes, or contain themselves.
_DEEPEST = 50
_MOST_VALUES = 1_000_000


def text(sections: Mapping[str, Any]) -> str:
    """The case file for nested mappings, one key a line."""
    lines: list[str] = []
    for key, value in sections.items():
        _lines([str(key)], value, lines)
    return "".join(line + "\n" for line in lines)


def _lines(path: list[str], value: Any, lines: list[str]) -> None:
    if isinstance(value, Mapping):
        _check_depth(path)
        if not value:
            lines.append(f"{_path(path)} = {{}}")
        for key, inner in value.items():
            _lines([*path, str(key)], inner, lines)
    elif value is not None:
        lines.append(f"{_path(path)} = {_value(path, value, len(path))}")


def _check_depth(path: list[str], depth: int = 0) -> None:
    if max(depth, len(path)) > _DEEPEST:
        raise CaseError(f"`{'.'.join(path[:3])}` is nested too deeply for a case")


def _path(path: list[str]) -> str:
    return ".".join(_key(key) for key in path)


def _key(key: str) -> str:
    bare = key and all(c.isascii() and (c.isalnum() or c in "_-") for c in key)
    return key if bare else _string(key)


def _string(value: str) -> str:
    """A basic string of TOML: JSON's, with the one control character that JSON leaves as it is."""
    try:
        value.encode()
    except UnicodeEncodeError:
        shown = value.encode("ascii", "backslashreplace").decode()
        raise CaseError(f'the text "{shown}" is no Unicode text: it holds half of a surrogate pair') from None
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")


def _value(path: list[str], value: Any, depth: int) -> str:
    _check_depth(path, depth)
    if isinstance(value, type):
        raise _no_value(path, value)
    if isinstance(value, str):
        return _string(value)
    if hasattr(value, "magnitude") and hasattr(value, "units"):
        return _string(_quantity(path, value))
    if hasattr(value, "tolist"):
        # Arrays and scalars of numpy: a truth value is one, and no number.
        _check_length(path, getattr(value, "size", 0))
        value = value.tolist()
        if isinstance(value, str):
            return _string(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, Mapping):
        inner = (f"{_key(str(k))} = {_value([*path, str(k)], v, depth + 1)}" for k, v in value.items())
        return "{ " + ", ".join(inner) + " }"
    if hasattr(value, "__index__"):
        whole = value.__index__()
        if abs(whole) >= 2**63:
            raise CaseError(f"`{'.'.join(path)}`: a whole number of {whole.bit_length()} bits is no value of a case")
        return str(whole)
    if hasattr(value, "__float__"):
        try:
            number = float(value)
        except (TypeError, ValueError, ArithmeticError):
            raise _no_value(path, value) from None
        if math.isnan(number):
            return "nan"
        if math.isinf(number):
            return "inf" if number > 0 else "-inf"
        return repr(number)
    if isinstance(value, Sequence) and not isinstance(value, (bytes, bytearray, memoryview)):
        _check_length(path, len(value))
        return "[" + ", ".join(_value(path, v, depth + 1) for v in value) + "]"
    if hasattr(value, "__fspath__") and isinstance(value.__fspath__(), str):
        return _string(value.__fspath__())
    raise _no_value(path, value)


def _check_length(path: list[str], n: int) -> None:
    if n > _MOST_VALUES:
        raise CaseError(f"`{'.'.join(path)}`: {n} values, and at most {_MOST_VALUES} are read")


def _no_value(path: list[str], value: Any) -> CaseError:
    return CaseError(
        f"`{'.'.join(path)}`: a {type(value).__name__} is no value of a case; "
        "give a string with a unit, a pint quantity, a number, a list or a mapping"
    )


def _quantity(path: list[str], value: Any) -> str:
    """A quantity of pint in SI base units, whose dimension the reader checks."""
    try:
        base = value.to_base_units()
        number = float(base.magnitude)
        items = list(base.unit_items())
    except (TypeError, ValueError, ArithmeticError, AttributeError):
        raise CaseError(
            f"`{'.'.join(path)}`: the quantity is not one number with a unit; give each value of a list its unit"
        ) from None
    parts = []
    for unit, power in items:
        symbol = _BASE_UNITS.get(str(unit))
        if symbol is None or float(power) != int(power):
            raise CaseError(f"`{value}`: its unit is not known to ertel; give a string such as \"16 mm\"")
        parts.append((symbol, int(power)))
    over = [_power(s, p) for s, p in parts if p > 0]
    under = [_power(s, -p) for s, p in parts if p < 0]
    unit = ".".join(over) or ("1" if under else "")
    for part in under:
        unit += "/" + part
    return f"{number!r} {unit}".strip()


_BASE_UNITS = {"meter": "m", "kilogram": "kg", "second": "s", "kelvin": "K", "radian": "rad"}


def _power(symbol: str, power: int) -> str:
    return symbol if power == 1 else f"{symbol}^{power}"

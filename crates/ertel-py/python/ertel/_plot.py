"""Pictures with matplotlib."""

from __future__ import annotations

import io
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _ertel

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure

    from ._result import Result
    from ._transient import Instant

# Those of curves in the program's pictures.
_PALETTE = _ertel.palette()

# Prefixes that suit fields of a contact.
_SHOWN = {"Pa": (1e-6, "MPa"), "m": (1e9, "nm"), "1/s": (1e-6, "1/µs")}


def _shown(**options: Any) -> Figure:
    """A figure that notebooks show, also where pyplot was never imported."""
    from matplotlib.figure import Figure

    figure = Figure(**options)
    # IPython asks objects for this.
    setattr(figure, "_repr_png_", partial(_png, figure))
    return figure


def _png(figure: Figure) -> bytes:
    content = io.BytesIO()
    figure.savefig(content, format="png", dpi=80)
    return content.getvalue()


def centreline(result: Result) -> Figure:
    """Pressure and film along y = 0, around the contact."""
    line = result.centreline
    x = line["x_over_a"]
    shown = (x > -2.0) & (x < 1.6)
    figure = _shown(figsize=(6.4, 4.0), layout="constrained")
    pressure_axes = figure.add_subplot()
    pressure_axes.plot(x[shown], line["pressure_Pa"][shown] * 1e-6, color=_PALETTE[0], label="pressure")
    pressure_axes.plot(
        x[shown], line["hertz_pressure_Pa"][shown] * 1e-6, color="tab:gray", linestyle="--", label="pressure, dry contact"
    )
    pressure_axes.set(xlabel="x/a", ylabel="pressure (MPa)", ylim=(0.0, None))
    film_axes = pressure_axes.twinx()
    central = float(result.film_central)
    film_axes.plot(x[shown], line["film_thickness_m"][shown] * 1e9, color=_PALETTE[1], label="film thickness")
    film_axes.set(ylabel="film thickness (nm)", ylim=(0.0, 4e9 * central))
    handles = [*pressure_axes.get_lines(), *film_axes.get_lines()]
    # Outside the axes: it must not cover a curve.
    figure.legend(handles=handles, loc="outside lower center", ncols=3, frameon=False)
    pressure_axes.set_title(result.title)
    return figure


def field_map(result: Result, values: NDArray[np.float64], unit: str, words: str) -> Figure:
    """A field over the contact, or along a line contact."""
    from matplotlib.patheffects import withStroke
    from matplotlib.tri import Triangulation

    half_width = result.to_dict()["hertz"]["half_width"]
    factor, unit = _SHOWN.get(unit, (1.0, unit))
    x, y = (result.points / half_width).T
    figure = _shown(figsize=(6.4, 4.6), layout="constrained")
    axes = figure.add_subplot()
    axes.set_title(result.title)
    label = f"{words} ({unit})"
    if result.is_line:
        order = np.argsort(x)
        axes.plot(x[order], values[order] * factor, color=_PALETTE[0])
        axes.set(xlabel="x/a", ylabel=label, xlim=(-2.0, 1.6))
        return figure
    x_low, x_high, y_low, y_high = (limit / half_width for limit in result._frame())
    triangulation = Triangulation(x, y, result.triangles)
    # Colours of a film belong to the contact, not to the wide gap around it.
    top = 1.5 * float(result.film_central) if words == "film thickness" else values.max()
    top = max(top, 1.2 * values.min())
    drawn = axes.tripcolor(triangulation, values * factor, shading="gouraud", vmin=values.min() * factor, vmax=top * factor)
    axes.set(xlabel="x/a", ylabel="y/a", aspect="equal", xlim=(x_low, x_high), ylim=(y_low, y_high))
    # The motion, as in the program's pictures.
    ends = [(0.05, 0.94), (0.19, 0.94)]
    look = {"arrowstyle": "->", "linewidth": 1.5, "color": "white", "path_effects": [withStroke(linewidth=3.5, foreground="black")]}
    axes.annotate("", ends[1], ends[0], "axes fraction", "axes fraction", look)
    figure.colorbar(drawn, label=label, extend="max" if top < values.max() else "neither")
    return figure


def instant_figure(instant: Instant, title: str) -> Figure:
    """Film and pressure of a line contact at an instant, or the film of another one."""
    x, y, film = instant.x * 1e3, instant.y * 1e3, instant.film * 1e9
    most = 1.5e9 * float(instant.film_central)
    figure = _shown(figsize=(6.4, 4.6), layout="constrained")
    axes = figure.add_subplot()
    axes.set_title(f"{title}, t = {instant.time * 1e3:.4g} ms")
    if len(y) < 2:
        axes.plot(x, film, color=_PALETTE[0])
        axes.set(xlabel="x (mm)", ylabel="film thickness (nm)", ylim=(0.0, most))
        pressed = instant.pressure > 0.01 * instant.pressure.max()
        if pressed.any():
            axes.set_xlim(1.2 * x[pressed].min(), 1.2 * x[pressed].max())
        pressure_axes = axes.twinx()
        pressure_axes.plot(x, instant.pressure * 1e-6, color=_PALETTE[1], linestyle="--")
        pressure_axes.set(ylabel="pressure (MPa), dashed", ylim=(0.0, None))
        return figure
    drawn = axes.pcolormesh(x, y, film, shading="gouraud", vmin=film.min(), vmax=max(most, film.min()))
    axes.set(xlabel="x (mm)", ylabel="y (mm)", aspect="equal")
    figure.colorbar(drawn, label="film thickness (nm)")
    return figure


def study_figure(rows: pd.DataFrame, axes: list[str], name: str, x: str | None, title: str, is_scattered: bool = False) -> Figure:
    """A figure over one of the axes, a curve for each combination of the others; points alone where all axes vary at once."""
    import pandas as pd

    column, error, unit = _columns(rows, name)
    if not axes:
        raise KeyError("nothing varies: there is no axis to plot over")
    x = x or next((axis for axis in axes if pd.api.types.is_numeric_dtype(rows[axis]) and rows[axis].nunique() > 1), axes[0])
    if x not in axes:
        raise KeyError(f"no axis `{x}`: there are {', '.join(axes)}")
    others = [] if is_scattered else [axis for axis in axes if axis != x and rows[axis].nunique() > 1]
    groups = list(rows.groupby(others, sort=True)) if others else [((), rows)]
    factor, shown = _SHOWN.get(unit, (1.0, unit))
    x_words, x_unit, x_factor, x_shift = _column_in_words(x)
    numeric = pd.api.types.is_numeric_dtype(rows[x])
    figure = _shown(figsize=(6.4, 4.0), layout="constrained")
    drawn = figure.add_subplot()
    for i, (values, group) in enumerate(groups):
        group = group.sort_values(x)
        values = values if isinstance(values, tuple) else (values,)
        label = ", ".join(_value_in_words(axis, value) for axis, value in zip(others, values))
        bars = None if error is None else group[error].to_numpy(float) * factor
        drawn.errorbar(
            x_factor * group[x].to_numpy() + x_shift if numeric else group[x].to_numpy(), group[column].to_numpy(float) * factor, bars, marker="o", markersize=4, capsize=2,
            linestyle="none" if is_scattered else "-",
            color=_PALETTE[i % len(_PALETTE)], label=label or None,
        )
    words = {own: text for own, text, _ in _ertel.figure_names()}.get(name, name.replace("_", " "))
    drawn.set(xlabel=f"{x_words} ({x_unit})" if x_unit else x_words, ylabel=f"{words} ({shown})" if shown else words, title=title)
    if others:
        figure.legend(loc="outside lower center", ncols=2, frameon=False)
    return figure


# Ends of column names, the longest first: the unit shown, and what turns SI into it.
_UNITS: dict[str, tuple[str, float, float]] = {
    "_kg_per_m3": ("kg/m³", 1.0, 0.0), "_rad_per_s": ("rpm", 30.0 / np.pi, 0.0), "_1_per_Pa": ("1/GPa", 1e9, 0.0), "_1_per_K": ("1/K", 1.0, 0.0),
    "_N_per_m": ("kN/m", 1e-3, 0.0), "_m_per_s": ("m/s", 1.0, 0.0), "_Pa_s": ("Pa·s", 1.0, 0.0), "_N_m": ("N m", 1.0, 0.0), "_degC": ("°C", 1.0, 0.0),
    "_rad": ("°", 180.0 / np.pi, 0.0), "_Pa": ("MPa", 1e-6, 0.0), "_m": ("mm", 1e3, 0.0), "_N": ("N", 1.0, 0.0), "_W": ("W", 1.0, 0.0),
    "_K": ("°C", 1.0, -273.15), "_s": ("s", 1.0, 0.0),
}  # fmt: skip


def _column_in_words(column: str) -> tuple[str, str, float, float]:
    """Words of a column, unit, factor and shift: entrainment speed and m/s of ``motion.entrainment_speed_m_per_s``."""
    name = column.rpartition(".")[2]
    unit = ("", 1.0, 0.0)
    for end, found in _UNITS.items():
        if name.endswith(end):
            name, unit = name.removesuffix(end), found
            break
    return name.replace("_", " ").replace("slide to roll", "slide-to-roll"), *unit


def _value_in_words(column: str, value: object) -> str:
    """``load 30 kN/m``, ``squalane-pip``: a value of an axis."""
    words, unit, factor, shift = _column_in_words(column)
    if not isinstance(value, (int, float)) or isinstance(value, bool):
        return str(value)
    return f"{words} {factor * value + shift:.6g} {unit}".rstrip()


def _columns(rows: pd.DataFrame, name: str) -> tuple[str, str | None, str]:
    """Titles of the columns of a figure and of its error bar, and its unit: figures are followed by their bars."""
    names = {}
    for error in map(str, rows.columns):
        figure, found, unit = error.partition("_error")
        if found and figure + unit in rows.columns:
            names[figure] = (figure + unit, error, unit.removeprefix("_"))
    if name not in names:
        raise KeyError(f"no figure `{name}` in the table: there are {', '.join(names)}")
    column, error, unit = names[name]
    return column, error, unit.replace("_per_", "/").replace("_", " ")

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
    pressure_axes.set(xlabel="x/a (-)", ylabel="pressure (MPa)", ylim=(0.0, None))
    film_axes = pressure_axes.twinx()
    central = float(result.film_central)
    film_axes.plot(x[shown], line["film_thickness_m"][shown] * 1e9, color=_PALETTE[1], label="film thickness")
    film_axes.set(ylabel="film thickness (nm)", ylim=(0.0, 4e9 * central))
    handles = [*pressure_axes.get_lines(), *film_axes.get_lines()]
    # Beside the curves, none of which it may cover.
    figure.legend(handles=handles, loc="outside lower center", ncols=3, frameon=False)
    pressure_axes.set_title(result.title)
    return figure


def field_map(result: Result, values: NDArray[np.float64], unit: str, words: str) -> Figure:
    """A field over the contact, or along a line contact."""
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
        axes.set(xlabel="x/a (-)", ylabel=label, xlim=(-2.0, 1.6))
        return figure
    x_low, x_high, y_low, y_high = (limit / half_width for limit in result._frame())
    # Colours for what lies around the contact, not for the wide gap at the edges.
    near = np.hypot(x / 1.3, y / (1.1 * max(-y_low, y_high))) < 1.0
    low, high = values[near].min() * factor, values[near].max() * factor
    triangulation = Triangulation(x, y, result.triangles)
    drawn = axes.tripcolor(triangulation, values * factor, shading="gouraud", vmin=low, vmax=high)
    axes.set(xlabel="x/a (-)", ylabel="y/a (-)", aspect="equal", xlim=(x_low, x_high), ylim=(y_low, y_high))
    figure.colorbar(drawn, label=label)
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
    figure = _shown(figsize=(6.4, 4.0), layout="constrained")
    drawn = figure.add_subplot()
    for i, (values, group) in enumerate(groups):
        group = group.sort_values(x)
        values = values if isinstance(values, tuple) else (values,)
        label = ", ".join(f"{axis} = {value:.4g}" if isinstance(value, float) else f"{axis} = {value}" for axis, value in zip(others, values))
        bars = None if error is None else group[error].to_numpy(float) * factor
        drawn.errorbar(
            group[x].to_numpy(), group[column].to_numpy(float) * factor, bars, marker="o", markersize=4, capsize=2,
            linestyle="none" if is_scattered else "-",
            color=_PALETTE[i % len(_PALETTE)], label=label or None,
        )
    words = {own: text for own, text, _ in _ertel.figure_names()}.get(name, name.replace("_", " "))
    drawn.set(xlabel=x, ylabel=f"{words} ({shown})" if shown else words, title=title)
    if others:
        figure.legend(loc="outside lower center", ncols=2, frameon=False)
    return figure


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

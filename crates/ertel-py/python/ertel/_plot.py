"""Pictures with matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ._result import Result

# Prefixes that suit fields of a contact.
_SHOWN = {"Pa": (1e-6, "MPa"), "m": (1e9, "nm"), "1/s": (1e-6, "1/µs")}


def centreline(result: Result) -> Figure:
    """Pressure and film along y = 0, around the contact."""
    from matplotlib.figure import Figure

    line = result.centreline
    x = line["x_over_a"]
    shown = (x > -2.0) & (x < 1.6)
    figure = Figure(figsize=(6.4, 4.0), layout="constrained")
    pressure_axes = figure.add_subplot()
    pressure_axes.plot(x[shown], line["pressure_Pa"][shown] * 1e-6, color="tab:red", label="pressure")
    pressure_axes.plot(
        x[shown], line["hertz_pressure_Pa"][shown] * 1e-6, color="tab:red", linestyle=":", label="pressure, dry contact"
    )
    pressure_axes.set(xlabel="x/a (-)", ylabel="pressure (MPa)", ylim=(0.0, None))
    film_axes = pressure_axes.twinx()
    central = float(result.film_central)
    film_axes.plot(x[shown], line["film_thickness_m"][shown] * 1e9, color="tab:blue", label="film thickness")
    film_axes.set(ylabel="film thickness (nm)", ylim=(0.0, 4e9 * central))
    handles = [*pressure_axes.get_lines(), *film_axes.get_lines()]
    # Beside the curves, none of which it may cover.
    figure.legend(handles=handles, loc="outside lower center", ncols=3, frameon=False)
    pressure_axes.set_title(result.case.title)
    return figure


def field_map(result: Result, values: NDArray[np.float64], unit: str, words: str) -> Figure:
    """A field over the contact, or along a line contact."""
    from matplotlib.figure import Figure
    from matplotlib.tri import Triangulation

    half_width = result.to_dict()["hertz"]["half_width"]
    factor, unit = _SHOWN.get(unit, (1.0, unit))
    x, y = (result.points / half_width).T
    figure = Figure(figsize=(6.4, 4.6), layout="constrained")
    axes = figure.add_subplot()
    axes.set_title(result.case.title)
    label = f"{words} ({unit})"
    if result.is_line:
        order = np.argsort(x)
        axes.plot(x[order], values[order] * factor)
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

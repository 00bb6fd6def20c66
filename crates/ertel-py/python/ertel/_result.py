"""Results: figures with their error bars, fields over the contact, pictures."""

from __future__ import annotations

import html
import json
import math
import operator
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _ertel
from ._ertel import CaseError, OutputError
from ._quantity import _FIELD_NAMES, _FIGURE_NAMES, Quantity, _read
from ._stored import Stored, Warned, columns, document, shaped, surface

if TYPE_CHECKING:
    import pandas as pd
    import pyvista as pv
    import xarray as xr
    from matplotlib.figure import Figure

    from ._case import Case

Floats = NDArray[np.float64]

# Components of a stress, in the order of documents and arrays.
_COMPONENTS = ("xx", "yy", "zz", "xy", "xz", "yz")


_Extent = tuple[float, float, float, float]

# Points of a grid: with some twenty fields these take half a gigabyte.
_MOST_GRID_POINTS = 5_000_000


def _grid(n_points: int, extent: _Extent | None) -> tuple[int, _Extent | None]:
    """Points along x and limits, checked."""
    try:
        n = operator.index(n_points)
    except TypeError:
        raise CaseError(f"n_points = {n_points!r}: a whole number") from None
    if n < 2:
        raise CaseError("n_points: two at least")
    if n > _MOST_GRID_POINTS:
        raise CaseError(f"n_points: at most {_MOST_GRID_POINTS}")
    if extent is None:
        return n, None
    try:
        x_low, x_high, y_low, y_high = (float(limit) for limit in extent)
    except (TypeError, ValueError, OverflowError):
        raise CaseError(f"extent = {extent!r}: four numbers in m, (x_low, x_high, y_low, y_high)") from None
    spans = (x_high - x_low, y_high - y_low)
    # Line contacts have no extent along y.
    if not (all(map(math.isfinite, (*spans, x_low, y_low))) and spans[0] > 0.0 and spans[1] >= 0.0):
        raise CaseError(f"extent = {extent!r}: finite numbers in m, x_low below x_high and y_low below y_high")
    return n, (x_low, x_high, y_low, y_high)


class Result(Warned, Stored):
    """The solution of a case. Numbers in SI, x along the motion, z normal to the contact, body 1 the plane.

    Every field of the contact is an attribute with its values at :attr:`points`: ``pressure`` (Pa), ``film_thickness`` (m),
    ``viscosity`` (Pa.s), ``temperature_mid`` (K, with heat) and what else :attr:`field_names` lists. Every figure is an attribute, too
    (``film_centreline_minimum``, ``roller_moment``, ``heat_shear``, ...), None where this contact does not have it; :meth:`figures` lists them.
    """

    _native: _ertel.NativeSolution | None
    _contact: tuple[Floats, NDArray[np.uint32], dict[str, Floats]] | None = None
    _centreline: dict[str, Floats] | None = None

    def __init__(self, case: Case, native: _ertel.NativeSolution) -> None:
        self._set_origin(case)
        self._native = native
        self._document = json.loads(native.document())
        self._report = native.report()

    @classmethod
    def _read(cls, folder: Path, inputs: Path | None) -> Result:
        result = cls.__new__(cls)
        result._set_origin(None, folder, inputs)
        result._native = None
        path = folder / "result.json"
        result._document = document(path, "ertel-result", ("title", "kind", "figures", "hertz", "warnings", "summary"))
        shaped(path, lambda: (result._figures(), result.hertz_pressure, repr(result)))
        return result

    # Figures

    @property
    def film_central(self) -> Quantity:
        """Film thickness in the centre of the contact, m."""
        return self._known("film_central")

    @property
    def film_minimum(self) -> Quantity:
        """Smallest film thickness, m."""
        return self._known("film_minimum")

    @property
    def pressure_central(self) -> Quantity:
        """Top of the smooth hill of the pressure in the middle of the contact, Pa."""
        return self._known("pressure_central")

    @property
    def pressure_maximum(self) -> Quantity:
        """Largest pressure, Pa; a lower bound where it is not ``resolved``, because a ridge may exceed it."""
        return self._known("pressure_maximum")

    @property
    def hertz_pressure(self) -> float:
        """Largest pressure of the dry contact, Pa."""
        return self._document["hertz"]["pressure"]

    @property
    def traction_coefficient(self) -> Quantity:
        """Traction force over load; positive where body 2 is the faster one."""
        return self._known("traction_coefficient")

    @property
    def friction_power(self) -> Quantity:
        """Heat of friction, W (W/m of line contacts)."""
        return self._known("friction_power")

    @property
    def film_temperature_maximum(self) -> Quantity | None:
        """Largest temperature of the film, K; None without heat."""
        return self.figure("film_temperature_maximum")

    def figure(self, name: str) -> Quantity | None:
        """A figure by its name in ``result.json``; None where this contact does not have it.

        Raises
        ------
        KeyError
            With the names that there are.
        """
        if name not in _FIGURE_NAMES:
            raise KeyError(f"no figure `{name}`: there are {', '.join(_FIGURE_NAMES)}")
        entry = self._document["figures"].get(name)
        if entry is None:
            return None
        bars = (self._document.get("uncertainty") or {}).get(name)
        return _read(entry, bars.get("half_width") if isinstance(bars, dict) else None)

    @property
    def sensitivities(self) -> dict[str, dict[str, float]]:
        """For each figure d ln(figure)/d ln(input), by the input's key path; empty where they were not computed."""
        return self._document.get("sensitivities") or {}

    @property
    def is_line(self) -> bool:
        """Whether it is a line contact."""
        return self._document["kind"] == "line"

    def _known(self, name: str) -> Quantity:
        found = self.figure(name)
        if found is None:
            raise KeyError(f"this contact has no `{name}`")
        return found

    def _figures(self) -> dict[str, Quantity]:
        found = ((name, self.figure(name)) for name in _FIGURE_NAMES)
        return {name: quantity for name, quantity in found if quantity is not None}

    # Fields

    def _fields(self) -> tuple[Floats, NDArray[np.uint32], dict[str, Floats]]:
        if self._contact is None:
            if self._native is None:
                self._contact = surface(self._stored("fields") / "surface.vtu")
            else:
                points, cells, fields = self._native.contact()
                self._contact = (points, cells, dict(fields))
        return self._contact

    @property
    def points(self) -> Floats:
        """Points of the whole contact area, m, shape (n, 2); y = 0 in line contacts."""
        return self._fields()[0]

    @property
    def triangles(self) -> NDArray[np.uint32]:
        """Triangles by their corners, shape (m, 3); segments, shape (m, 2), in line contacts."""
        return self._fields()[1]

    @property
    def field_names(self) -> list[str]:
        """Names of the fields that this contact has."""
        return list(self._fields()[2])

    def field(self, name: str) -> Floats:
        """Values of a field at :attr:`points`, SI.

        Raises
        ------
        KeyError
            With the names that there are.
        """
        fields = self._fields()[2]
        if name not in fields:
            raise KeyError(f"no field `{name}`: this contact has {', '.join(fields)}")
        return fields[name]

    def __getattr__(self, name: str) -> Any:
        if name in _FIGURE_NAMES:
            return self.figure(name)
        if name.startswith("_") or name not in _FIELD_NAMES:
            raise AttributeError(f"a result has no attribute `{name}`")
        try:
            return self.field(name)
        except KeyError as error:
            raise AttributeError(error.args[0]) from None

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self.field_names, *self._document["figures"]})

    @property
    def centreline(self) -> dict[str, Floats]:
        """Profiles along y = 0, by the names of the columns of ``centreline.csv``."""
        if self._centreline is None:
            if self._native is None:
                self._centreline = columns(self._stored("profiles") / "centreline.csv")
            else:
                self._centreline = dict(self._native.centreline())
        return self._centreline

    def stress_profile(self, body: int = 1, below: str = "middle") -> dict[str, Floats]:
        """Stresses in a body over depth, Pa and m, below the ``"middle"`` of the contact or the ``"largest"`` stress after von Mises.

        Keys: ``depth``, the components ``xx``, ``yy``, ``zz``, ``xy``, ``xz``, ``yz`` (x along the motion, z into the body, tension positive) and
        ``orthogonal_range``, the range of ``xz`` that points of this depth see while the contact passes. Interfaces of layers have two depths, one for each side.

        Raises
        ------
        KeyError
            Without ``[stress]`` in the case, and for another place.
        """
        profile = self._stressed(body)[{"middle": "axis", "largest": "below_largest"}[below]]
        components = np.array(profile["stress"], dtype=float).T
        found = {"depth": np.array(profile["depth"], dtype=float)}
        found |= dict(zip(_COMPONENTS, components, strict=True))
        return found | {"orthogonal_range": np.array(profile["orthogonal_range"], dtype=float)}

    def stress_section(self, body: int = 1) -> dict[str, Floats]:
        """Stresses in a body in the plane of motion through the middle of the contact, SI.

        Keys: ``x``, ``depth``, and the components as in :meth:`stress_profile`, each of the shape (depths, places).

        Raises
        ------
        KeyError
            Without ``[stress]`` in the case, and for a stored result, whose section is in ``stress.vtu``.
        """
        self._stressed(body)
        section = None if self._native is None else self._native.stress_section(body - 1)
        if section is None:
            raise KeyError("stored results have the section in `stress.vtu`")
        x, depth, stress = section
        return {"x": x, "depth": depth} | dict(zip(_COMPONENTS, stress, strict=True))

    def _stressed(self, body: int) -> dict[str, Any]:
        if body not in (1, 2):
            raise KeyError(f"no body {body}: there are 1 and 2")
        stress = self._document.get("stress")
        if stress is None:
            raise KeyError("this result has no stresses: the case has no [stress]")
        return stress["bodies"][body - 1]

    def to_xarray(self, n_points: int = 201, extent: tuple[float, float, float, float] | None = None) -> xr.Dataset:
        """Fields on a regular grid, `n_points` along x; not a number outside the contact area.

        Parameters
        ----------
        n_points : int
            Points along x; across, the grid has the same distance.
        extent : tuple of float, optional
            Limits (x_low, x_high, y_low, y_high), m; by default the contact and a margin, of ellipses and rollers all of it along y.

        Returns
        -------
        xarray.Dataset
            Dimensions (y, x) in m, or x alone of a line contact; each variable with its unit.

        Raises
        ------
        CaseError
            For fewer than two points along x or more than five millions in all, and for limits that are not four numbers, each low one
            below its high one.
        """
        import xarray as xr

        x, y = self._axes(n_points, extent)
        points, cells, fields = self._fields()
        grids = _ertel.fields_on_grid(points, cells, list(fields.items()), x, y)
        data = {}
        for name, values in grids:
            unit, words = _FIELD_NAMES[name]
            attributes = {"units": unit, "long_name": words}
            data[name] = ("x", values[0], attributes) if self.is_line else (("y", "x"), values, attributes)
        position = {"units": "m", "long_name": "position along the motion"}
        coordinates: dict[str, Any] = {"x": ("x", np.array(x), position)}
        if not self.is_line:
            coordinates["y"] = ("y", np.array(y), {"units": "m", "long_name": "position across the motion"})
        return xr.Dataset(data, coordinates, {"title": self.title})

    def to_netcdf(
        self, path: str | os.PathLike[str], n_points: int = 201, extent: tuple[float, float, float, float] | None = None
    ) -> Path:
        """Write the fields of :meth:`to_xarray` and every figure as a netCDF file of the classic format (64-bit offsets).

        Each figure is a variable without dimension, with ``units`` and ``long_name``, and, where they are known, ``error`` (half-width of
        the error bar), ``resolved`` (1 or 0), ``uncertainty``, ``x`` and ``y`` (m). ``[output] netcdf = true`` writes the same, ``result.nc``.

        Parameters
        ----------
        path : path
            The file; a former one is replaced.
        n_points, extent
            As of :meth:`to_xarray`.

        Raises
        ------
        OutputError
            When the file cannot be written.
        """
        axes = self._axes(n_points, extent)
        points, cells, fields = self._fields()
        about = (self.title, self._document["kind"], self._document["ertel_version"])
        figures = [(name, q.value, q.error, q.uncertainty, q.resolved, q.place) for name, q in self._figures().items()]
        content = _ertel.netcdf_bytes(about, points, cells, list(fields.items()), axes, figures)
        try:
            Path(path).write_bytes(content)
        except OSError as error:
            raise OutputError(f"{os.fspath(path)}: cannot be written: {error.strerror}") from None
        return Path(path)

    def _axes(self, n_points: int, extent: _Extent | None) -> tuple[list[float], list[float]]:
        """Points of a grid along x and y, m; by default over the contact and a margin."""
        n_points, extent = _grid(n_points, extent)
        sizes = (self._document["hertz"]["half_width"], self.hertz_pressure)
        return _ertel.contact_grid(self.points, self.field("pressure"), sizes, self.is_line, n_points, extent)

    def _frame(self) -> _Extent:
        """The contact and a margin: what pictures show."""
        x, y = self._axes(2, None)
        return x[0], x[-1], y[0], y[-1]

    def to_pandas(self) -> pd.DataFrame:
        """Fields at the points: columns x, y (m) and one for each field, SI."""
        import pandas as pd

        points, _, fields = self._fields()
        return pd.DataFrame({"x": points[:, 0], "y": points[:, 1], **fields})

    def figures(self) -> pd.DataFrame:
        """Every figure that this contact has: a row for each with value, error, uncertainty, unit, place (m) and what it is, in words."""
        import pandas as pd

        rows = {}
        for name, q in self._figures().items():
            x, y = q.place or (None, None)
            rows[name] = [q.value, q.error, q.uncertainty, q.unit, q.resolved, x, y, _FIGURE_NAMES[name][0]]
        columns = ["value", "error", "uncertainty", "unit", "resolved", "x", "y", "words"]
        return pd.DataFrame.from_dict(rows, orient="index", columns=columns)

    def to_pyvista(self) -> pv.UnstructuredGrid:
        """The contact area with its fields as point data; their units as JSON in the field data ``units``, as in ``surface.vtu``."""
        import pyvista as pv

        points, cells, fields = self._fields()
        n_corners = cells.shape[1]
        heads = np.full((len(cells), 1), n_corners, dtype=np.int64)
        kind = pv.CellType.LINE if n_corners == 2 else pv.CellType.TRIANGLE
        spatial = np.column_stack([points, np.zeros(len(points))])
        flat = np.hstack([heads, cells.astype(np.int64)]).ravel()
        grid = pv.UnstructuredGrid(flat, np.full(len(cells), kind), spatial)
        for name, values in fields.items():
            grid.point_data[name] = values
        units = {"points": "m"} | {name: _FIELD_NAMES[name][0] for name in fields}
        grid.field_data["units"] = np.frombuffer(json.dumps(units).encode(), dtype=np.uint8)
        return grid

    def plot(self, field: str | None = None) -> Figure:
        """Draw pressure and film along the centreline, or a map of a field.

        Parameters
        ----------
        field : str, optional
            Name of a field; in line contacts it is drawn along x.

        Returns
        -------
        matplotlib.figure.Figure
        """
        from ._plot import centreline, field_map

        if field is None:
            return centreline(self)
        unit, words = _FIELD_NAMES.get(field, ("", ""))
        return field_map(self, self.field(field), unit, words)

    def save(self, folder: str | os.PathLike[str]) -> Path:
        """Write the files of ``ertel solve``; a former result in the folder is replaced, anything else is not.

        Raises
        ------
        OutputError
            When the folder holds something else, or cannot be written.
        """
        self._alive("the files of a result").save(Path(folder))
        return Path(folder)

    def _alive(self, what: str) -> _ertel.NativeSolution:
        if self._native is None:
            raise self._refuse(what)
        return self._native

    def _started(self) -> _ertel.NativeSolution | None:
        # A result that was pickled has no start; without one a solve begins at the dry contact.
        return self._native

    def __getstate__(self) -> dict[str, Any]:
        self._fields()
        _ = self.centreline
        return super().__getstate__()

    def __repr__(self) -> str:
        return f"<ertel.Result: h_c {self.film_central}, h_min {self.film_minimum}, p_c {self.pressure_central}>"

    def _repr_html_(self) -> str:
        rows = []
        for name, quantity in self._figures().items():
            words, symbol = _FIGURE_NAMES[name]
            if not symbol:
                continue
            words = html.escape(words)
            rows.append(f"<tr><td>{words}</td><td>{html.escape(str(quantity))}</td></tr>")
        title = html.escape(self.title or "ertel result")
        warnings = "".join(f"<li>{html.escape(w)}</li>" for w in self.warnings)
        notes = f"<ul>{warnings}</ul>" if warnings else ""
        return f"<table><caption>{title}</caption><tbody>{''.join(rows)}</tbody></table>{notes}"

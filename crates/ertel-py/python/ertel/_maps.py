"""Maps of surfaces: files of heights that a case names."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _ertel
from ._ertel import CaseError

# Metres in a unit, as instruments and SurfaceTopography write them.
_UNITS = {"m": 1.0, "mm": 1e-3, "µm": 1e-6, "μm": 1e-6, "um": 1e-6, "nm": 1e-9, "pm": 1e-12, "Å": 1e-10, "A": 1e-10}


def write_map(
    path: str | os.PathLike[str], surface: Any, *, sizes: Sequence[float] | float | None = None, unit: str | None = None
) -> Path:
    """Write heights to a file that a case names: ``surface=[{"kind": "map", "file": "wear.sdf", "body": "body_1", "x": "0 m"}]``.

    The file is ASCII SDF (ISO 25178-71), which has its units in it.

    Parameters
    ----------
    path : path
        The file; a case finds it in its own folder.
    surface : object or array
        An object with ``heights()``, ``physical_sizes`` and ``unit``, as a topography of SurfaceTopography is one; or an array of
        heights, whose first axis lies along the rows of the map and whose second one, if it has one, across them. Masked values and
        NaN are points without a height.
    sizes : float or sequence of float, optional
        Lengths of the sides in `unit`, each the number of points times their distance; those of the object by default.
    unit : str, optional
        Unit of heights and sizes: "m", "mm", "um", "nm" and so on; that of the object by default.

    Returns
    -------
    Path
        The path as given.

    Raises
    ------
    CaseError
        For heights, sizes or a unit that make no map.
    """
    values: Any = surface
    if callable(getattr(surface, "heights", None)):
        values = surface.heights()
        sizes = getattr(surface, "physical_sizes", None) if sizes is None else sizes
        unit = getattr(surface, "unit", None) if unit is None else unit
    if unit is None:
        raise CaseError('unit: what the heights are in, such as unit="um"')
    if unit not in _UNITS:
        raise CaseError(f"unit = {unit!r}: one of {', '.join(_UNITS)}")
    if sizes is None:
        raise CaseError("sizes: lengths of the sides of the map")
    try:
        if np.iscomplexobj(values):
            raise CaseError("heights are complex numbers; give their real parts")
        heights: NDArray[np.float64] = np.ma.filled(np.ma.asarray(values, dtype=float), np.nan)
        lengths = np.atleast_1d(np.asarray(sizes, dtype=float))
    except CaseError:
        raise
    except (TypeError, ValueError) as error:
        raise CaseError(f"heights and sizes are numbers: {error}") from None
    if heights.ndim not in (1, 2) or lengths.shape != (heights.ndim,):
        raise CaseError(f"heights of {heights.ndim} axes and {lengths.size} sizes: one or two axes, and a size for each")
    least, most = _ertel.MAP_POINTS
    if min(heights.shape) < least or heights.size > most:
        shape = " x ".join(map(str, heights.shape))
        raise CaseError(f"{shape} points: a map has {least} in each direction at least and {most} at most, a profile {least} to {most}")
    if not (np.all(np.isfinite(lengths)) and np.all(lengths > 0.0)):
        raise CaseError(f"sizes = {sizes!r}: lengths above zero")
    if np.any(np.isinf(heights)):
        raise CaseError("a height is infinite; a point without one is NaN or masked")
    factor = _UNITS[unit]
    rows = np.atleast_2d(heights.T) * factor
    spacing = lengths * factor / heights.shape
    counts = (heights.shape[0], 1 if heights.ndim == 1 else heights.shape[1])
    lines = [
        "aISO-1.0",
        f"ManufacID   = ertel {_ertel.__version__}",
        f"NumPoints   = {counts[0]}",
        f"NumProfiles = {counts[1]}",
        f"Xscale      = {float(spacing[0])!r}",
        f"Yscale      = {float(spacing[-1])!r}",
        "Zscale      = 1",
        "Zresolution = -1",
        "Compression = 0",
        "DataType    = 7",
        "CheckType   = 0",
        "*",
    ]
    lines += [" ".join("BAD" if np.isnan(h) else repr(float(h)) for h in row) for row in rows]
    path = Path(path)
    path.write_text("\n".join([*lines, "*", ""]), encoding="ascii")
    return path

"""Lubricants, materials, and laws from measurements."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _ertel


def fluids() -> list[str]:
    """Names of the lubricants, own ones first."""
    return _ertel.names("fluids")


def solids() -> list[str]:
    """Names of the materials of bodies, own ones first."""
    return _ertel.names("solids")


def own_data(folder: str | os.PathLike[str]) -> None:
    """Let names stand for the files ``fluids/NAME.toml`` and ``solids/NAME.toml`` of a folder; once in a process."""
    _ertel.use_own_data(Path(folder))


def viscosity(fluid: str, pressure: ArrayLike, temperature: float) -> NDArray[np.float64]:
    """Low-shear viscosity of a lubricant, Pa.s.

    Parameters
    ----------
    fluid : str
        Name in the database, or a file.
    pressure : array_like
        Pressure above ambient, Pa.
    temperature : float
        K.
    """
    pressures = np.asarray(pressure, dtype=float)
    values, _ = _ertel.viscosity(fluid, pressures.ravel().tolist(), float(temperature))
    return np.array(values).reshape(pressures.shape)


@dataclass(frozen=True)
class Fit:
    """A fitted law.

    Attributes
    ----------
    constants : dict
        Constants by their keys, SI.
    intervals : dict
        Their 95 % intervals, SI; None of those that were held.
    rms : float
        Root mean square of law/measured - 1.
    warnings : list of str
        What the data leave open, and what makes no sense.
    text : str
        The file of the lubricant; :meth:`save` writes it.
    """

    constants: dict[str, float]
    intervals: dict[str, tuple[float, float] | None]
    rms: float
    warnings: list[str]
    text: str

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write the file of the lubricant, which a case can name; an existing file is not replaced."""
        with open(path, "x", encoding="utf-8") as file:
            file.write(self.text)
        return Path(path)


def fit_viscosity(
    table: str | os.PathLike[str], law: str, *, hold: Mapping[str, str] | None = None, title: str | None = None
) -> Fit:
    """Fit a viscosity law to a CSV table of measured states, as ``ertel fit viscosity`` does.

    Parameters
    ----------
    table : path
        Columns with units, as ``pressure_MPa, temperature_degC, viscosity_mPa_s``.
    law : str
        ``roelands``, ``cheng``, ``yasutomi`` and others; an unknown one is refused with the choices.
    hold : mapping, optional
        Constants that keep a value, as ``{"mu_0": "40 mPa.s"}``.
    title : str, optional
        Title of the lubricant; the name of the table by default.
    """
    return _fit("viscosity", Path(table), law, hold, title)


def fit_density(
    table: str | os.PathLike[str], law: str, *, hold: Mapping[str, str] | None = None, title: str | None = None
) -> Fit:
    """Fit a density law to a CSV table; see :func:`fit_viscosity`."""
    return _fit("density", Path(table), law, hold, title)


def _fit(kind: str, path: Path, law: str, hold: Mapping[str, str] | None, title: str | None) -> Fit:
    held = list((hold or {}).items())
    text = path.read_text(encoding="utf-8-sig")
    constants, rms, warnings, entry = _ertel.fit_law(
        kind, str(path), text, law, held, title or path.stem, path.name
    )
    return Fit(
        constants={key: value for key, value, _, _ in constants},
        intervals={key: None if bounds is None else (bounds[0], bounds[1]) for key, _, _, bounds in constants},
        rms=rms,
        warnings=warnings,
        text=entry,
    )

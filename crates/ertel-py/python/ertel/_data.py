"""Lubricants, materials, and laws from measurements."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _ertel
from ._ertel import CaseError, OutputError


def explain(code: str) -> dict[str, str]:
    """Meaning of the code of a warning: ``meaning``, ``limit`` with its source, ``remedy``.

    Raises
    ------
    CaseError
        An unknown code; the message lists all.
    """
    return dict(zip(("meaning", "limit", "remedy"), _ertel.explanation(code)))


def fluids() -> list[str]:
    """Names of the lubricants, own ones first."""
    return _ertel.names("fluids")


def solids() -> list[str]:
    """Names of the materials of bodies, own ones first."""
    return _ertel.names("solids")


def own_data(folder: str | os.PathLike[str]) -> None:
    """Use the files ``fluids/NAME.toml`` and ``solids/NAME.toml`` of a folder by name; once in a process."""
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
    pressures = _numbers("pressure", pressure)
    values, _ = _ertel.viscosity(fluid, pressures.ravel().tolist(), _number("temperature", temperature))
    return np.array(values).reshape(pressures.shape)


def _numbers(name: str, values: ArrayLike) -> NDArray[np.float64]:
    try:
        return np.asarray(values, dtype=float)
    except (TypeError, ValueError):
        raise CaseError(f"{name}: numbers in SI, without unit") from None


def _number(name: str, value: float) -> float:
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise CaseError(f"{name} = {value!r}: one number in SI, without unit") from None


@dataclass(frozen=True)
class Fluid:
    """A lubricant of the database, of the own data, or of a file.

    Attributes
    ----------
    name : str
        Name or file.
    title : str
        Short description.
    viscosity_law, shear_thinning_law, density_law : str or None
        Names of its laws.
    reference_temperature : float or None
        Temperature at which reference viscosity and density hold, K.
    notes : list of str
        Notes to read before use.
    sources : dict
        Value as written and source of each datum, by its key.
    """

    name: str
    title: str
    viscosity_law: str | None
    shear_thinning_law: str | None
    density_law: str | None
    reference_temperature: float | None
    notes: list[str]
    sources: dict[str, tuple[str, str]]

    def viscosity(self, pressure: ArrayLike, temperature: float) -> NDArray[np.float64]:
        """Low-shear viscosity, Pa.s, at pressures above ambient (Pa) and a temperature (K)."""
        return viscosity(self.name, pressure, temperature)

    def density(self, pressure: ArrayLike, temperature: float) -> NDArray[np.float64]:
        """Density, kg/m^3, at pressures above ambient (Pa) and a temperature (K); not a number without a law."""
        pressures = _numbers("pressure", pressure)
        _, values = _ertel.viscosity(self.name, pressures.ravel().tolist(), _number("temperature", temperature))
        return np.array(values).reshape(pressures.shape)


def fluid(name: str) -> Fluid:
    """Look up a lubricant by its name in the database or by its file.

    Raises
    ------
    CaseError
        An unknown name, with the names that are near, or a file with an error.
    """
    title, laws, temperature, notes, sources = _ertel.fluid(name)
    by_key = {key: (value, source) for key, value, source in sources}
    return Fluid(name, title, laws[0], laws[1], laws[2], temperature, notes, by_key)


@dataclass(frozen=True)
class FilmFit:
    """A film-thickness formula fitted to computed films.

    Attributes
    ----------
    constants : dict
        Constants of the form by their names; None for the exponent of a variable that does not vary.
    intervals : dict
        Their confidence intervals, which reflect scatter only, not model error.
    rms : float
        Root mean square of formula/film - 1.
    warnings : list of str
        Constants that the films do not determine.
    """

    constants: dict[str, float | None]
    intervals: dict[str, tuple[float, float] | None]
    rms: float
    warnings: list[str]


def fit_film(
    table: str | os.PathLike[str], form: str = "moes", *, radius: float | None = None, confidence: float = 0.95
) -> dict[str, FilmFit]:
    """Fit a film-thickness formula to a table of films, as ``ertel fit film`` does.

    Parameters
    ----------
    table : path
        The table of a study, or a CSV file with ``film_central_m`` or ``film_minimum_m`` and what the form needs.
    form : str
        ``moes``, ``hamrock-dowson``, ``elliptical``, ``blend``, ``speed`` or ``speed-load``.
    radius : float, optional
        Reduced radius of all films, m; the column ``radius_m`` by default.
    confidence : float
        Confidence of the intervals.

    Returns
    -------
    dict
        The fits of the ``central`` and the ``minimum`` film, as far as the table has them.

    Raises
    ------
    CaseError
        A table that cannot be read, with line and column; an unknown form; too few films.
    """
    path = Path(table)
    length = None if radius is None else _number("radius", radius)
    found = _ertel.fit_film(str(path), _ertel.table_text(path), form, length, _number("confidence", confidence))
    return {
        kind: FilmFit(
            constants={name: None if c is None else c[0] for name, c in constants},
            intervals={name: None if c is None else (c[1][0], c[1][1]) for name, c in constants},
            rms=rms,
            warnings=warnings,
        )
        for kind, constants, rms, warnings in found
    }


@dataclass(frozen=True)
class StribeckFit:
    """Boundary friction and roughness by a measured Stribeck curve.

    Attributes
    ----------
    constants : dict
        ``boundary_friction_coefficient``, ``rms_height`` (composite, m) and perhaps ``asperity_group``; None where the readings do not determine it.
    uncertainties : dict
        Their standard uncertainties, from the scatter of the readings.
    correlations : dict
        Coefficients of correlation by pairs of names.
    points : list of dict
        ``line`` of the table, ``point``, and the friction coefficients ``measured``, ``fitted`` and ``asperities``, the part of the asperities.
    scatter : float
        Standard deviation of the readings from the fit; over their uncertainties where the table gives them for all.
    warnings : list of str
        Limits of the fit.
    section : str
        ``[surface_roughness]`` of a case file with these constants.
    """

    constants: dict[str, float | None]
    uncertainties: dict[str, float | None]
    correlations: dict[tuple[str, str], float]
    points: list[dict[str, int | str | float]]
    scatter: float
    warnings: list[str]
    section: str


def fit_stribeck(
    case: str | os.PathLike[str],
    measured: str | os.PathLike[str],
    *,
    asperity_group: bool = False,
    ignore: Sequence[str] = (),
    columns: Mapping[str, str] | None = None,
    decimal: Literal["point", "comma"] | None = None,
) -> StribeckFit:
    """Fit boundary friction and roughness to a measured Stribeck curve, as ``ertel fit stribeck`` does.

    Parameters
    ----------
    case, measured : path
        The case file with asperities, and the table with ``traction_coefficient`` over the speed (docs/guide/mixed-lubrication.md).
    asperity_group : bool
        Whether to fit the asperity group as well.
    ignore, columns, decimal : optional
        As in :func:`compare`.

    Raises
    ------
    CaseError
        A case without asperities or sliding, a table that cannot be read, too few readings.
    ConvergenceError
        Contacts that do not converge.
    """
    constants, correlations, points, scatter, warnings, section = _ertel.fit_stribeck(
        Path(case),
        Path(measured),
        asperity_group=asperity_group,
        ignored=list(ignore),
        columns=list((columns or {}).items()),
        decimal=decimal,
    )
    return StribeckFit(
        constants={name: value for name, value, _ in constants},
        uncertainties={name: standard for name, _, standard in constants},
        correlations={(one, other): value for (one, other), value in correlations},
        points=[
            {"line": line, "point": point, "measured": friction, "fitted": fitted, "asperities": asperities}
            for line, point, (friction, fitted, asperities) in points
        ],
        scatter=scatter,
        warnings=warnings,
        section=section,
    )


@dataclass(frozen=True)
class Fit:
    """A fitted law.

    Attributes
    ----------
    constants : dict
        Constants by their keys, SI.
    intervals : dict
        Their 95 % intervals, SI; None of those that were fixed.
    rms : float
        Root mean square of law/measured - 1.
    warnings : list of str
        Constants that the data do not determine, and implausible ones.
    text : str
        The file of the lubricant; :meth:`save` writes it.
    """

    constants: dict[str, float]
    intervals: dict[str, tuple[float, float] | None]
    rms: float
    warnings: list[str]
    text: str

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write the file of the lubricant, which a case can name; an existing file is not replaced.

        Raises
        ------
        OutputError
            For a file that is there already, or cannot be written.
        """
        try:
            with open(path, "x", encoding="utf-8") as file:
                file.write(self.text)
        except OSError as error:
            raise OutputError(f"cannot write {path}: {error.strerror}") from error
        return Path(path)


def fit_viscosity(
    table: str | os.PathLike[str],
    law: str,
    *,
    hold: Mapping[str, str] | None = None,
    title: str | None = None,
    density: str | os.PathLike[str] | None = None,
    reference_temperature: str | None = None,
    pressure_law: str = "roelands",
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
    density : str or path, optional
        Name or file of a lubricant with the density: for ``walther``, for ``doolittle`` (a Tait equation), and for tables of
        kinematic viscosities.
    reference_temperature : str, optional
        Reference temperature of the law, as ``"40 degC"``; the isotherm in the middle of the data by default. For ``walther`` with
        a fixed coefficient ``alpha``, the temperature at which it holds.
    pressure_law : str, optional
        ``roelands`` or ``barus``: how the viscosity of ``walther`` grows with pressure.
    """
    given = (None if density is None else os.fspath(density), reference_temperature, pressure_law)
    return _fit("viscosity", Path(table), law, hold, title, given)


def fit_density(
    table: str | os.PathLike[str], law: str, *, hold: Mapping[str, str] | None = None, title: str | None = None
) -> Fit:
    """Fit a density law to a CSV table; see :func:`fit_viscosity`."""
    return _fit("density", Path(table), law, hold, title)


def _fit(
    kind: str,
    path: Path,
    law: str,
    hold: Mapping[str, str] | None,
    title: str | None,
    given: tuple[str | None, str | None, str] = (None, None, "roelands"),
) -> Fit:
    held = list((hold or {}).items())
    for key, value in held:
        if not isinstance(value, str):
            raise CaseError(f"hold[{key!r}] = {value!r}: write it with its unit, as \"40 mPa.s\"")
    text = _ertel.table_text(path)
    constants, rms, warnings, entry = _ertel.fit_law(
        kind, str(path), text, law, held, title or path.stem, path.name, *given
    )
    return Fit(
        constants={key: value for key, value, _, _ in constants},
        intervals={key: None if bounds is None else (bounds[0], bounds[1]) for key, _, _, bounds in constants},
        rms=rms,
        warnings=warnings,
        text=entry,
    )

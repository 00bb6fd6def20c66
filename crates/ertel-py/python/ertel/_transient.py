"""Cases in time."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _ertel
from ._quantity import Quantity
from ._stored import Floats, Tabulated, document, shaped

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ._case import Case


class Instant:
    """A contact at an instant.

    Attributes
    ----------
    time : float
        Time, s.
    load : float
        Load, N, of line contacts N/m.
    film_force : float
        Force of the film, in the same unit: that of the load, unless a body moves by its inertia or its approach is given.
    approach, approach_velocity : float
        By how much the bodies have come nearer since t = 0, m, and its rate, m/s.
    entrainment_speed, body_1_speed, body_2_speed : float
        Speeds, m/s.
    mass_error : float
        Mass that the film gained or lost in the step, over what passes the centre at the largest entrainment speed.
    """

    def __init__(self, given: dict[str, Any]) -> None:
        self._given = given
        self.time: float = given["time"]
        self.load: float = given["load"]
        self.film_force: float = given["film_force"]
        self.approach: float = given["approach"]
        self.approach_velocity: float = given["approach_velocity"]
        self.entrainment_speed: float = given["entrainment_speed"]
        self.body_1_speed: float = given["body_1_speed"]
        self.body_2_speed: float = given["body_2_speed"]
        self.mass_error: float = given["mass_error"]

    @property
    def names(self) -> list[str]:
        """Names of its figures."""
        return list(self._given["figures"])

    def __getitem__(self, name: str) -> Quantity:
        """A figure with its error bar, SI.

        Raises
        ------
        KeyError
            With the names that there are.
        """
        figures = self._given["figures"]
        if name not in figures:
            raise KeyError(f"{name}: an instant has {', '.join(figures)}")
        figure = figures[name]
        return Quantity(figure["value"], figure.get("error"))

    @property
    def film_central(self) -> Quantity:
        """Central film thickness, m."""
        return self["film_central"]

    @property
    def film_minimum(self) -> Quantity:
        """Minimum film thickness, m."""
        return self["film_minimum"]

    def __repr__(self) -> str:
        return f"<ertel.Instant: {self.time:.4e} s, central film {self.film_central.value:.4e} m>"


class Transient(Tabulated):
    """A case with ``[transient]`` from its start on.

    Iteration runs over its instants; ``len`` counts them.
    """

    _native: _ertel.NativeTransient | None
    _table_file = "transient.csv"
    _instants: list[Instant]

    def __init__(self, case: Case, native: _ertel.NativeTransient) -> None:
        self._set_origin(case)
        self._native = native
        self._document = json.loads(native.document())
        self._table = native.table()
        self._report = native.report()
        self._instants = [Instant(given) for given in self._document["instants"]]

    @classmethod
    def _read(cls, folder: Path, inputs: Path | None) -> Transient:
        transient = cls.__new__(cls)
        transient._set_origin(None, folder, inputs)
        transient._native = None
        path = folder / "transient.json"
        transient._document = document(path, "ertel-transient", ("title", "complete", "instants", "profiles"))
        transient._instants = shaped(path, lambda: [Instant(given) for given in transient._document["instants"]])
        return transient

    @property
    def complete(self) -> bool:
        """Whether time came to its end."""
        return bool(self._document["complete"])

    @property
    def reason(self) -> str | None:
        """Why it did not."""
        return self._document["reason"]

    @property
    def coefficient_of_restitution(self) -> float | None:
        """Of a body that fell on the film and has left it."""
        return self._document["coefficient_of_restitution"]

    @property
    def warnings(self) -> list[str]:
        """What you should know."""
        return list(self._document["warnings"])

    @property
    def time(self) -> Floats:
        """Times of the instants, s."""
        return np.array([instant.time for instant in self._instants])

    def series(self, name: str) -> Floats:
        """A figure at all instants, SI; not a number where an instant has none."""
        known = {figure for instant in self._instants for figure in instant.names}
        if name not in known:
            raise KeyError(f"{name}: the instants have {', '.join(sorted(known))}")
        return np.array([instant[name].value if name in instant.names else np.nan for instant in self._instants])

    @property
    def profiles(self) -> list[dict[str, Any]]:
        """The centreline at the output times: ``time`` (s), arrays ``x`` (m), ``pressure`` (Pa) and ``film_thickness`` (m)."""
        arrays = ("x", "pressure", "film_thickness")
        return [{"time": p["time"], **{key: np.array(p[key]) for key in arrays}} for p in self._document["profiles"]]

    def to_dict(self) -> dict[str, Any]:
        """What ``transient.json`` has."""
        return self._document

    def plot(self, figure: str = "film_central") -> Figure:
        """Draw a figure over time, in the colours of the program.

        Raises
        ------
        KeyError
            With the names that there are.
        """
        from ._plot import study_figure

        return study_figure(self.to_pandas(), ["time_s"], figure, "time_s", self.title)

    def save(self, folder: str | os.PathLike[str]) -> Path:
        """Write what ``ertel solve`` writes."""
        if self._native is None:
            raise self._refuse("the files of a course in time")
        self._native.save(Path(folder))
        return Path(folder)

    def __len__(self) -> int:
        return len(self._instants)

    def __iter__(self) -> Iterator[Instant]:
        return iter(self._instants)

    def __getitem__(self, index: int) -> Instant:
        return self._instants[index]

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_native": None}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)

    def __repr__(self) -> str:
        end = "" if self.complete else ", ended early"
        return f"<ertel.Transient: {len(self)} instants{end}>"

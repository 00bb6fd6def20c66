"""Cases in time."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _ertel
from ._ertel import OutputError
from ._quantity import Quantity
from ._stored import Floats, Tabulated, Warned, collection, document, shaped, surface

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ._case import Case


class _Fields:
    """Fields at an output time: places (m), pressure (Pa) and film (m), along a line or row by row across the motion."""

    def __init__(self, x: Floats, y: Floats, pressure: Floats, film: Floats) -> None:
        shape = (len(x),) if len(y) < 2 else (len(y), len(x))
        self.x, self.y = x, y
        self.pressure, self.film = (np.asarray(values, dtype=float).reshape(shape) for values in (pressure, film))


class Instant:
    """A contact at an instant. Those of the output times have fields, too.

    Attributes
    ----------
    time : float
        Time, s.
    load : float
        Load, N, of line contacts N/m.
    film_force : float
        Force of the film, in the same unit: that of the load, unless a body moves by its inertia or its approach is given.
    radius : float
        Radius along the motion, m.
    temperature : float
        Temperature of bodies and oil, K.
    oil_layer : float or None
        Thickness of the layer of oil at the inlet edge, m; none for a flooded inlet.
    approach, approach_velocity : float
        Approach of the bodies since t = 0, m, and its rate, m/s.
    entrainment_speed, body_1_speed, body_2_speed : float
        Speeds, m/s.
    body_1_spin, body_2_spin : float
        Angular velocities about the contact normal, rad/s.
    mass_error : float
        Mass that the film gained or lost in the step, over what passes the centre at the largest entrainment speed.
    """

    def __init__(self, given: dict[str, Any], fields: Callable[[float], _Fields] | None = None) -> None:
        self._given = given
        self._of = fields
        self._found: _Fields | None = None
        self.time: float = given["time"]
        self.load: float = given["load"]
        self.film_force: float = given["film_force"]
        self.radius: float = given["radius"]
        self.temperature: float = given["temperature"]
        self.oil_layer: float | None = given["oil_layer"]
        self.approach: float = given["approach"]
        self.approach_velocity: float = given["approach_velocity"]
        self.entrainment_speed: float = given["entrainment_speed"]
        self.body_1_speed: float = given["body_1_speed"]
        self.body_2_speed: float = given["body_2_speed"]
        self.body_1_spin: float = given["body_1_spin"]
        self.body_2_spin: float = given["body_2_spin"]
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

    def _fields(self) -> _Fields:
        if self._found is None:
            if self._of is None:
                raise OutputError(f"there are no fields at {self.time} s: `output_times` of [transient] are the instants that keep them")
            self._found = self._of(self.time)
        return self._found

    @property
    def has_fields(self) -> bool:
        """Whether it is one of the output times, which keep their fields."""
        return self._of is not None

    @property
    def x(self) -> Floats:
        """Places along the motion, m.

        Raises
        ------
        OutputError
            At an instant that is no output time, and of a folder without the files of the fields.
        """
        return self._fields().x

    @property
    def y(self) -> Floats:
        """Places across the motion, m: 0 alone in line contacts. Raises as :attr:`x`."""
        return self._fields().y

    @property
    def pressure(self) -> Floats:
        """Pressure, Pa: at each ``x`` in line contacts, at each ``y`` and ``x`` (rows along the motion) in others. Raises as :attr:`x`."""
        return self._fields().pressure

    @property
    def film(self) -> Floats:
        """Film thickness, m, of the same shape. Raises as :attr:`x`."""
        return self._fields().film

    @property
    def amplitude_ratio(self) -> float | None:
        """Amplitude ratio of waves in the central film for the passage that ends here; None where no whole wave has passed."""
        ratio = self._given.get("amplitude_ratio")
        return None if ratio is None else float(ratio)

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


class Transient(Warned, Tabulated):
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
        self._instants = self._with_fields()

    @classmethod
    def _read(cls, folder: Path, inputs: Path | None) -> Transient:
        transient = cls.__new__(cls)
        transient._set_origin(None, folder, inputs)
        transient._native = None
        path = folder / "transient.json"
        transient._document = document(path, "ertel-transient", ("title", "complete", "instants", "profiles"))
        transient._instants = shaped(path, transient._with_fields)
        return transient

    def _with_fields(self) -> list[Instant]:
        """The instants; those of the output times know where their fields are."""
        kept = {profile["time"] for profile in self._document["profiles"]}
        return [Instant(given, self._fields_at if given["time"] in kept else None) for given in self._document["instants"]]

    def _fields_at(self, time: float) -> _Fields:
        number = next(i for i, profile in enumerate(self._document["profiles"]) if profile["time"] == time)
        if self._native is not None:
            _, x, y = self._native.grid()
            found = self._native.fields(number)
            assert found is not None
            return _Fields(x, y, found[0].astype(float), found[1].astype(float))
        files = self._folder / "fields.pvd" if self._folder is not None else None
        if files is None or not files.exists():
            profile = self._document["profiles"][number]
            if self._document["case"]["si"]["contact"]["kind"] == "line":
                x, pressure, film = (np.array(profile[key]) for key in ("x", "pressure", "film_thickness"))
                source = self._folder / "transient.json" if self._folder is not None else Path("a pickled case in time")
                return shaped(source, lambda: _Fields(x, np.zeros(1), pressure, film))
            where = files or "a pickled case in time"
            raise OutputError(f"{where}: there are no fields off the centreline; solve with `vtu = true` in [output] to have them written")
        _, path = collection(files)[number]
        points, _, fields = surface(path)
        x, y = (np.unique(points[:, axis]) for axis in (0, 1))
        return shaped(path, lambda: _Fields(x, y, fields["pressure"], fields["film_thickness"]))

    @property
    def complete(self) -> bool:
        """Whether the run is complete."""
        return bool(self._document["complete"])

    @property
    def reason(self) -> str | None:
        """Why it is not."""
        return self._document["reason"]

    @property
    def coefficient_of_restitution(self) -> float | None:
        """Rebound of a body that fell on the film and has left it."""
        return self._document["coefficient_of_restitution"]

    @property
    def over_time(self) -> dict[str, dict[str, Any]]:
        """Figures of the whole run by their names, as ``film_minimum_lowest``: ``value`` and ``error`` (SI), ``time`` at which it is (s, none of means), ``resolved``, ``unit``, ``words``."""
        return self._document.get("over_time", {})

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

    @property
    def outputs(self) -> list[Instant]:
        """The instants of the output times, which have fields."""
        return [instant for instant in self._instants if instant.has_fields]

    def plot(self, figure: str | int = "film_central") -> Figure:
        """Draw a figure over time, or the contact at an instant, in the colours of the program.

        Parameters
        ----------
        figure : str or int
            Name of a figure, or number of an instant as in ``transient[i]``, one of an output time: then film and pressure of a line contact, or the film of another one.

        Raises
        ------
        KeyError
            With the names that there are.
        OutputError
            For an instant without fields.
        """
        from ._plot import instant_figure, study_figure

        if not isinstance(figure, str):
            return instant_figure(self._instants[figure], self.title)
        return study_figure(self.to_pandas(), ["time_s"], figure, "time_s", self.title)

    def to_netcdf(self, path: str | os.PathLike[str]) -> Path:
        """Write figures at all instants and fields at the output times as a netCDF file of the classic format, as ``[output] netcdf = true`` does.

        Raises
        ------
        OutputError
            When the file cannot be written, and of a folder without ``result.nc``.
        """
        return self._put(path, "result.nc", None if self._native is None else self._native.netcdf())

    def animate(self, path: str | os.PathLike[str]) -> Path:
        """Write an animated picture (APNG) of the contact at the output times, as ``[output] animation = true`` does.

        Raises
        ------
        OutputError
            When the file cannot be written, without output times, and of a folder without ``animation.png``.
        """
        return self._put(path, "animation.png", None if self._native is None else self._native.animation())

    def _put(self, path: str | os.PathLike[str], name: str, content: bytes | None) -> Path:
        """Writes a file of this process, or copies that of the folder."""
        if content is None and self._native is not None:
            raise OutputError(f"{os.fspath(path)}: nothing was solved at an output time")
        if content is None:
            former = self._folder / name if self._folder is not None else None
            if former is None or not former.exists():
                raise self._refuse(name)
            content = former.read_bytes()
        try:
            Path(path).write_bytes(content)
        except OSError as error:
            raise OutputError(f"{os.fspath(path)}: cannot be written: {error.strerror}") from None
        return Path(path)

    def save(self, folder: str | os.PathLike[str]) -> Path:
        """Write the files of ``ertel solve``."""
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

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        # They asked the process that solved the case.
        self._instants = self._with_fields()

    def __repr__(self) -> str:
        end = "" if self.complete else ", ended early"
        return f"<ertel.Transient: {len(self)} instants{end}>"

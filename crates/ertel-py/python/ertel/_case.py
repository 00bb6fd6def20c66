"""Cases: contacts and machines to be solved."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Callable, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any, Literal

from . import _ertel, _toml
from ._curve import Curve
from ._ertel import CaseError
from ._laws import UNITS, ErtelWarning, Law, TabulatedLaw, tabulated
from ._machine import MachineSolution
from ._result import Result
from ._transient import Transient

Progress = bool | Callable[[dict[str, Any]], object] | None


class Case:
    """A contact, its bodies, motion and lubricant, read and checked as a case file is.

    Parameters
    ----------
    folder : path, optional
        Folder of the files that the case names (tables, own lubricants); the current one by default.
    **sections
        The keys of a case file (docs/reference/case-file.md). Quantities are strings with a unit, ``"16 mm"`` or
        ``"40 mPa.s ± 5 %"``, or pint quantities; sections are mappings.

    Raises
    ------
    CaseError
        For an unknown or missing key, a wrong unit, an impossible value; the text is that of the program.

    Examples
    --------
    >>> case = Case(
    ...     contact={"kind": "line", "radius": "10 mm", "load": "100 kN/m"},
    ...     bodies={"body_1": "steel", "body_2": "steel"},
    ...     motion={"entrainment_speed": "2 m/s", "slide_to_roll_ratio": 0.0},
    ...     lubricant="squalane-pip",
    ...     temperature="40 degC",
    ... )
    >>> round(case.estimate()["hertz"]["pressure"] / 1e6)
    606
    """

    _native: _ertel.NativeCase
    _tabulated: Mapping[str, TabulatedLaw] = MappingProxyType({})

    def __init__(self, *, folder: str | os.PathLike[str] = "", **sections: Any) -> None:
        if not sections:
            raise CaseError("an empty case: give its sections, as contact={...}, or use Case.from_file")
        text = _toml.text(sections)
        self._native = _ertel.NativeCase("case made in Python", text, Path(folder))

    @classmethod
    def from_file(cls, path: str | os.PathLike[str]) -> Case:
        """Read a case file.

        Parameters
        ----------
        path : path
            The file, TOML.
        """
        return cls._of(_ertel.NativeCase.read(Path(path)))

    @classmethod
    def from_text(cls, text: str, *, name: str = "case.toml", folder: str | os.PathLike[str] = "") -> Case:
        """Read the text of a case file; errors call it `name`."""
        return cls._of(_ertel.NativeCase(name, text, Path(folder)))

    @classmethod
    def _of(cls, native: _ertel.NativeCase) -> Case:
        case = cls.__new__(cls)
        case._native = native
        return case

    def with_(self, settings: Mapping[str, Any]) -> Case:
        """The same case with other values, as ``--set`` of the program makes it.

        Parameters
        ----------
        settings : mapping
            Values by key path, ``{"motion.entrainment_speed": "2 m/s"}``: what a case takes, also pint quantities, numbers, lists and tables.

        Raises
        ------
        CaseError
            For an unknown key, with the choices, and for a value that the key does not take.

        Warns
        -----
        ErtelWarning
            If the case exceeds the pressures or temperatures for which :meth:`with_law` tabulated a law.

        Examples
        --------
        >>> faster = case.with_({"motion.entrainment_speed": "4 m/s"})   # doctest: +SKIP
        """
        if not isinstance(settings, Mapping):
            raise CaseError(f"settings: a mapping from key paths to values, not a {type(settings).__name__}")
        texts = []
        for key, value in settings.items():
            if not isinstance(key, str) or "=" in key:
                raise CaseError(f"{key!r} is no key path: write it as \"contact.load\"")
            texts.append(f"{key}={_toml._value(key.split('.'), value, 0)}")
        # The class of what it returns is that of a case read from a file: keywords of a machine are in its text.
        case = Case._of(self._native.with_settings(texts))
        replaced = [key.split(".") for key in settings]
        gone = [name for name in self._tabulated if any(["lubricant", name][: len(key)] == key[:2] for key in replaced)]
        if gone:
            text = case.text
            for name in gone:
                text = _without_note(text, name)
            native = case._native
            case = Case.from_text(text, name=native.name, folder=native.folder)
        case._tabulated = {name: note for name, note in self._tabulated.items() if name not in gone}
        case._look_at_tables()
        return case

    def _look_at_tables(self) -> None:
        """Warns where the case leaves the range of a law that was tabulated for another one."""
        if not self._tabulated:
            return
        pressure, temperature = self.estimate()["hertz"]["pressure"], self.si["temperature"]
        for name, law in self._tabulated.items():
            low, high = law.temperatures
            if pressure > law.pressures[1]:
                left = f"the Hertz pressure is {pressure * 1e-9:.4g} GPa, the table ends at {law.pressures[1] * 1e-9:.4g} GPa"
            elif not low <= temperature <= high:
                left = f"the lubricant has {temperature:.5g} K, the table {low:.5g} to {high:.5g} K"
            else:
                continue
            words = f"the {name} was tabulated for another case: {left}. The table is extrapolated linearly; call with_law again"
            warnings.warn(words, ErtelWarning, stacklevel=3)

    def with_law(
        self,
        name: Literal["viscosity", "density"],
        law: Law,
        *,
        pressures: tuple[float, float] | None = None,
        temperatures: tuple[float, float] | None = None,
        tolerance: float = 1e-4,
    ) -> Case:
        """The same case with a low-shear viscosity or a density that is a function of Python.

        The function is tabulated, as ``law = "table"`` of a case file, so that the case can be saved, pickled, and solved by the
        program. The table is refined until its interpolation error is below `tolerance`; :attr:`tabulated` and the first lines of
        :attr:`text` give an estimate of the remaining error.

        Parameters
        ----------
        name : {"viscosity", "density"}
            Which law of the lubricant: Pa.s or kg/m^3.
        law : callable
            Function of pressure above ambient (Pa) and temperature (K), both floats.
        pressures : tuple of float, optional
            Limits of the table, Pa; from 0 to twice the Hertz pressure by default. Beyond them the table is extrapolated linearly.
        temperatures : tuple of float, optional
            Limits, K; by default from 20 K below the temperature of the lubricant to 100 K above it.
        tolerance : float
            Largest relative interpolation error.

        Raises
        ------
        CaseError
            Where the function is not finite, not positive, or not smooth enough; the text says at which pressure and temperature.

        Examples
        --------
        >>> from math import exp
        >>> barus = case.with_law("viscosity", lambda p, t: 0.04 * exp(2e-8 * p))   # doctest: +SKIP
        """
        if name not in UNITS:
            raise CaseError(f"with_law: {name!r} is no law that may be a function: viscosity or density")
        if not callable(law):
            raise CaseError(f"law: a function of pressure (Pa) and temperature (K), not a {type(law).__name__}")
        if pressures is None:
            pressures = (0.0, 2.0 * self.estimate()["hertz"]["pressure"])
        if temperatures is None:
            inlet = self.si["temperature"]
            temperatures = (inlet - 20.0, inlet + 100.0)
        table, note = tabulated(name, law, pressures, temperatures, tolerance)
        other = self.with_({f"lubricant.{name}": table})
        text = f"# lubricant.{name}: {note}.\n{_without_note(other.text, name)}"
        native = self._native
        case = Case.from_text(text, name=native.name, folder=native.folder)
        case._tabulated = {**self._tabulated, name: note}
        return case

    @property
    def tabulated(self) -> dict[str, TabulatedLaw]:
        """Laws that :meth:`with_law` made, by name, with range and an estimate of the interpolation error."""
        return dict(self._tabulated)

    @property
    def text(self) -> str:
        """The case file."""
        return self._native.text

    @property
    def title(self) -> str:
        """Title, empty if there is none."""
        return self._native.title

    @property
    def warnings(self) -> list[str]:
        """Warnings about the input, one sentence each."""
        return self._native.warnings

    @property
    def is_curve(self) -> bool:
        """Whether it varies a quantity: then :meth:`solve` gives a :class:`Curve`."""
        return self._native.is_curve

    @property
    def is_transient(self) -> bool:
        """Whether it changes in time: then :meth:`solve` gives a :class:`Transient`."""
        return self._native.is_transient

    @property
    def is_machine(self) -> bool:
        """Whether it describes a whole machine, as a bearing under its loads: then :meth:`solve` gives a :class:`MachineSolution`."""
        return self._native.is_machine

    @property
    def given(self) -> dict[str, Any]:
        """Keys and values as they were given."""
        return json.loads(self._native.given())

    @property
    def si(self) -> dict[str, Any]:
        """The case as read, in SI."""
        return json.loads(self._native.si())

    @property
    def inputs(self) -> dict[str, float]:
        """Every quantity that was read, by its key path, in SI."""
        return {key: value for key, value, _ in self._native.inputs()}

    def estimate(self) -> dict[str, Any]:
        """Estimates by formulas, in milliseconds: dry contact, groups, regime, films (SI).

        Of a whole machine also ``figures``, by name as in :attr:`MachineSolution.figures`, ``not_estimated``, figures with what they need, and ``contacts`` with load,
        Hertz pressure and formula films; all other keys are those of its most loaded contact.
        """
        return json.loads(self._native.estimate())

    def estimate_report(self) -> str:
        """The same in words, as ``ertel estimate`` shows it."""
        return self._native.estimate_report()

    def solve(self, progress: Progress = None, start: Result | None = None) -> Result | Curve | Transient | MachineSolution:
        """Solve the contact, the points of its curve, its course in time, or all contacts of its machine.

        Ctrl-C stops after the iteration; other Python threads run on meanwhile.

        Parameters
        ----------
        progress : bool or callable, optional
            True prints a line for each Newton iteration; a callable is called with a dict for each event.
        start : Result, optional
            Result of a similar case, from which this one starts; where that does not lead to its own mesh and accuracy, it starts from
            the dry contact.

        Returns
        -------
        Result, Curve, Transient or MachineSolution
            A curve where the case has a ``[curve]``, a transient where it has ``[transient]``, a machine where it describes a whole one. Points and contacts that fail are kept with
            their reasons.

        Raises
        ------
        ConvergenceError
            Of a single contact, with how far it came, why, and what to try.
        KeyboardInterrupt
            On Ctrl-C.
        """
        listener = _listener(progress)
        if self.is_curve:
            if start is not None:
                raise CaseError("a curve starts from the dry contact: leave out `start`")
            return Curve(self, _ertel.solve_curve(self._native, listener))
        if self.is_transient:
            if start is not None:
                raise CaseError("time begins with the steady contact: leave out `start`")
            return Transient(self, _ertel.solve_transient(self._native, listener))
        if self.is_machine:
            if start is not None:
                raise CaseError("the contacts of a machine start from each other: leave out `start`")
            return MachineSolution(self, _ertel.solve_machine(self._native, listener))
        if start is not None and not isinstance(start, Result):
            raise CaseError(f"start: the result of a similar case, not a {type(start).__name__}")
        native = None if start is None else start._started()
        return Result(self, _ertel.solve(self._native, listener, native))

    def __reduce__(self) -> tuple[Any, ...]:
        native = self._native
        return (_restored, (type(self), native.name, native.text, str(native.folder), dict(self._tabulated)))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Case):
            return NotImplemented
        return self.text == other.text and self._native.folder == other._native.folder

    def __hash__(self) -> int:
        return hash(self.text)

    def __repr__(self) -> str:
        kind = self.si["contact"]["kind"]
        title = f" {self.title!r}" if self.title else ""
        what = f"whole machine, {kind} contacts" if self.is_machine else f"{kind} contact"
        return f"<ertel.Case{title}: {what}>"


def _without_note(text: str, name: str) -> str:
    """The text of a case without the note about a law from a function in its first lines."""
    return "".join(line for line in text.splitlines(keepends=True) if not line.startswith(f"# lubricant.{name}: table of a Python function"))


def _restored(cls: type[Case], name: str, text: str, folder: str, laws: dict[str, TabulatedLaw]) -> Case:
    case = cls.from_text(text, name=name, folder=folder)
    case._tabulated = laws
    return case


def _listener(progress: Progress) -> Callable[[str], None] | None:
    if progress is None or progress is False:
        return None
    if progress is not True and not callable(progress):
        raise CaseError(f"progress: True, or a function of one event, not a {type(progress).__name__}")
    if progress is True:
        return lambda message: _show(json.loads(message))
    return lambda message: _ignore(progress(json.loads(message)))


def _ignore(_: object) -> None:
    pass


def _show(event: Mapping[str, Any]) -> None:
    match event["event"]:
        case "stage":
            print(f"stage {event['stage']} of {event['n_stages']}: {event['pressure_unknowns']} pressure unknowns", flush=True)
        case "iteration":
            film = event["film_central"] * 1e9
            print(
                f"  {event['iteration']:3d}  residual {event['residual']:.1e}  update {event['update']:.1e}  h_c {film:.2f} nm",
                flush=True,
            )
        case "heat":
            print(f"  heat, round {event['round']}: change {event['change']:.1e}", flush=True)
        case "point":
            print(f"point {event['point']} of {event['n_points']}: {event['label']}", flush=True)


def estimate(case: Case) -> dict[str, Any]:
    """Estimates of a case by formulas; see :meth:`Case.estimate`."""
    return case.estimate()


def solve(case: Case, progress: Progress = None, start: Result | None = None) -> Result | Curve | Transient | MachineSolution:
    """Solve a case; see :meth:`Case.solve`."""
    return case.solve(progress, start)

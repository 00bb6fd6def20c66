"""Whole machines: their figures, and the contacts of which these are made."""

from __future__ import annotations

import html
import json
import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _ertel
from ._quantity import _FIGURE_NAMES, Quantity, _read
from ._stored import Tabulated, Warned, document, shaped

if TYPE_CHECKING:
    from ._case import Case


@dataclass(frozen=True, repr=False)
class MachineFigure(Quantity):
    """A figure of a whole machine, in SI; ``float(figure)`` is its value.

    Attributes
    ----------
    value : float
        From the solutions of all contacts, or from a formula.
    error : float or None
        Half-width of the bar that the discretisation errors of the contacts make; None where it comes from a formula alone.
    unit : str
        SI unit, empty for a pure number.
    words : str
        Description.
    source : str
        Source of the formula, or neglected parts; may be empty.
    marks : tuple of str
        Reason not to use the figure: ``"friction-beyond-lubricants"``, ``"not-resolved"``, ``"film-alone"``,
        ``"between-points"``; empty for results of older versions.
    """

    words: str = ""
    source: str = ""
    marks: tuple[str, ...] = ()

    @property
    def doubtful(self) -> bool:
        """Whether the figure is not to be used at all: not resolved, or derived from friction that no lubricant transmits."""
        return not self.resolved or "friction-beyond-lubricants" in self.marks


@dataclass(frozen=True)
class MachineContact:
    """One contact of a machine.

    Attributes
    ----------
    name : str
        Which it is: ``"ball 3, inner ring"``.
    place : float
        Where it is: angle from the load round a bearing (rad), distance from the pitch point along the line of action (m), angle of a cam
        (rad); :attr:`MachineSolution.place_name` says which.
    ring : str or None
        ``"inner"`` or ``"outer"`` in a bearing, else None.
    load : float
        N, or N/m of a line contact; 0 where nothing presses.
    hertz_pressure : float
        Largest pressure of the dry contact, Pa.
    solved_as : int or None
        Place in :attr:`MachineSolution.contacts` of the contact that was solved for it and all like it: itself or one before; None where
        nothing presses.
    figures : dict of str to Quantity, or None
        The figures of the solved contact by the names of :meth:`Result.figures`, the same object for contacts that are alike; None where
        nothing presses, and where the solve failed.
    failure : str or None
        Why the solve failed, if it did.
    """

    name: str
    place: float
    ring: str | None
    load: float
    hertz_pressure: float
    solved_as: int | None
    figures: dict[str, Quantity] | None = field(default=None, repr=False)
    failure: str | None = None

    def figure(self, name: str) -> Quantity | None:
        """A figure by its name, as of :meth:`Result.figure`; None where this contact does not have it.

        Raises
        ------
        KeyError
            With the names that there are.
        """
        if name not in _FIGURE_NAMES:
            raise KeyError(f"no figure `{name}`: there are {', '.join(_FIGURE_NAMES)}")
        return None if self.figures is None else self.figures.get(name)

    def __getattr__(self, name: str) -> Any:
        if name in _FIGURE_NAMES:
            return self.figure(name)
        raise AttributeError(f"a contact of a machine has no attribute `{name}`")


@dataclass(frozen=True)
class ContactFigure:
    """A figure at each contact of a machine: along a path of contact, round a bearing, over the turn of a cam. SI.

    Attributes
    ----------
    place : list of float
        The coordinate, as of :attr:`MachineContact.place`; where the load of a pair of teeth jumps, twice the same.
    contact : list of int
        Place in :attr:`MachineSolution.contacts`.
    value : list of float or None
        Values; None where there is none, as of films on the other side of a jump.
    error : list of float or None
        Half-widths of the bars.
    unit : str
        SI unit, empty for a pure number.
    words : str
        Description.
    label : list of str or None
        ``"A"`` to ``"E"`` on a path of contact.
    marks : tuple of str
        Marks of all values, as of :attr:`MachineFigure.marks`.
    """

    place: list[float]
    contact: list[int]
    value: list[float | None]
    error: list[float | None]
    unit: str
    words: str
    label: list[str | None]
    marks: tuple[str, ...] = ()


@dataclass(frozen=True)
class Shaft:
    """The inner ring of a bearing against the outer one. x is along the radial load, z along the bearing.

    Attributes
    ----------
    displacement : list of float
        Shifts along x, y and z (m) and tilts about x and y (rad).
    load : list of float
        Forces (N) and moments (N m) in the same order.
    stiffness : list of list of float
        Change of the load of the row with the displacement of the column, N/m, N and N m.
    """

    displacement: list[float]
    load: list[float]
    stiffness: list[list[float]]


class MachineSolution(Warned, Tabulated):
    """The solution of a whole machine. Numbers in SI.

    Figures of the machine are attributes (``machine.friction_torque``), and items of :attr:`figures`. Those that are sums over the contacts are
    there only where all contacts are solved.

    Attributes
    ----------
    case : Case
        The case.
    figures : dict of str to MachineFigure
        Figures of the machine by their names.
    contacts : list of MachineContact
        All contacts, unloaded ones among them; of a bearing those of each element with both rings.
    contact_figures : dict of str to ContactFigure
        Figures at each contact by their names: load share, flash temperature and others along a path of contact; load, contact angle and spin of the
        elements of a bearing; force, pressure angle and entrainment speed over the turn of a cam. Empty for results of older versions.
    shaft : Shaft or None
        Displacement, load and stiffness of a bearing; None for other machines.
    """

    _native: _ertel.NativeMachine | None
    _table_file = "machine.csv"
    figures: dict[str, MachineFigure]
    contacts: list[MachineContact]
    contact_figures: dict[str, ContactFigure]
    shaft: Shaft | None

    def __init__(self, case: Case, native: _ertel.NativeMachine) -> None:
        self._set_origin(case)
        self._native = native
        self._table = native.table()
        self._report = native.report()
        self._take(json.loads(native.document()))

    @classmethod
    def _read(cls, folder: Path, inputs: Path | None) -> MachineSolution:
        machine = cls.__new__(cls)
        machine._set_origin(None, folder, inputs)
        machine._native = None
        path = folder / "machine.json"
        content = document(path, "ertel-machine", ("title", "figures", "contacts", "governing_contact", "n_solved", "warnings"))
        shaped(path, lambda: machine._take(content))
        return machine

    def _take(self, content: dict[str, Any]) -> None:
        self._document = content
        self.figures = {
            name: MachineFigure(
                value=entry["value"],
                error=entry["error"],
                unit=entry["unit"],
                words=entry["words"],
                source=entry["source"],
                resolved=entry.get("resolved", True),
                marks=tuple(entry.get("marks", ())),
            )
            for name, entry in content["figures"].items()
        }
        self.contacts = _contacts(content["contacts"], self.place_name)
        self.contact_figures = _contact_figures(content.get("contact_figures"), self.place_name)
        shaft = content.get("shaft")
        self.shaft = shaft and Shaft(shaft["displacement"], shaft["load"], shaft["stiffness"])

    @property
    def failures(self) -> list[tuple[int, str]]:
        """Place and reason of the contacts without solution; those that are alike once."""
        contacts = enumerate(self.contacts)
        return [(i, c.failure) for i, c in contacts if c.failure is not None and c.solved_as == i]

    @property
    def failed(self) -> bool:
        """Whether a contact has no solution: sums over all contacts are omitted then."""
        return bool(self.failures)

    @property
    def governing_contact(self) -> MachineContact:
        """The contact under the largest pressure, or that of the pitch point."""
        return self.contacts[self._document["governing_contact"] - 1]

    @property
    def place_name(self) -> str:
        """Kind of :attr:`MachineContact.place`: ``"angle"`` (rad), ``"position"`` (m) or ``"cam_angle"`` (rad)."""
        first = self._document["contacts"][0]
        return next(name for name in _PLACES if name in first)

    def figure(self, name: str) -> MachineFigure | None:
        """A figure of the machine by its name; None where this machine does not have it."""
        return self.figures.get(name)

    def save(self, folder: str | os.PathLike[str]) -> Path:
        """Write the files of ``ertel solve``; a former result in the folder is replaced, anything else is not.

        Raises
        ------
        OutputError
            When the folder holds something else, or cannot be written.
        """
        if self._native is None:
            raise self._refuse("the files of a machine")
        self._native.save(Path(folder))
        return Path(folder)

    def __getattr__(self, name: str) -> Any:
        figures = self.__dict__.get("figures", {})
        if name in figures:
            return figures[name]
        have = f": its figures are {', '.join(figures)}" if figures and not name.startswith("_") else ""
        raise AttributeError(f"this machine has no attribute `{name}`{have}")

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self.figures})

    def __len__(self) -> int:
        return len(self.contacts)

    def __repr__(self) -> str:
        failed = f", {len(self.failures)} failed" if self.failed else ""
        n = self._document["n_solved"]
        return f"<ertel.MachineSolution: {len(self)} contacts, {n} different ones solved{failed}>"

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><td>{html.escape(figure.words)}</td><td>{html.escape(str(figure))}</td></tr>" for figure in self.figures.values()
        )
        title = html.escape(self.title or "ertel machine")
        warnings = "".join(f"<li>{html.escape(w)}</li>" for w in self.warnings)
        notes = f"<ul>{warnings}</ul>" if warnings else ""
        return f"<table><caption>{title}</caption><tbody>{rows}</tbody></table>{notes}"


_PLACES = ("angle", "position", "cam_angle")


def _contact_figures(entries: dict[str, Any] | None, place: str) -> dict[str, ContactFigure]:
    if entries is None:
        return {}
    contact = [number - 1 for number in entries["contact"]]
    label = entries.get("label", [None] * len(contact))
    return {
        name: ContactFigure(
            place=entries[place],
            contact=contact,
            value=entry["value"],
            error=entry["error"],
            unit=entry["unit"],
            words=entry["words"],
            label=label,
            marks=tuple(entry["marks"]),
        )
        for name, entry in entries["figures"].items()
    }


def _contacts(entries: list[dict[str, Any]], place: str) -> list[MachineContact]:
    solved: list[tuple[dict[str, Quantity] | None, str | None]] = []
    for entry in entries:
        solution = entry.get("solution") or {}
        figures = solution.get("figures")
        by_name = None if figures is None else {name: _read(figure) for name, figure in figures.items()}
        solved.append((by_name, solution.get("reason")))
    contacts = []
    for entry in entries:
        like = None if entry["solved_as"] is None else entry["solved_as"] - 1
        figures, failure = (None, None) if like is None else solved[like]
        contacts.append(
            MachineContact(
                name=entry["name"],
                place=entry[place],
                ring=entry.get("ring"),
                load=entry["load"],
                hertz_pressure=entry["hertz_pressure"],
                solved_as=like,
                figures=figures,
                failure=failure,
            )
        )
    return contacts

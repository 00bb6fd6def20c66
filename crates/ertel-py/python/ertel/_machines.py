"""Cases of machines by keywords: bearings, gear pairs and cams."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

from ._case import Case

# Sections of a case other than [machine] (docs/reference/case-file.md); every other keyword is a key of [machine].
_SECTIONS = (
    "title",
    "bodies",
    "surface_roughness",
    "inlet",
    "lubricant",
    "temperature",
    "thermal",
    "mesh",
    "solver",
    "output",
    "transient",
    "stress",
    "wear",
    "surface",
    "curve",
    "compare",
    "correlation",
)


class _MachineCase(Case):
    def __init__(
        self,
        *,
        kind: str | None,
        designation: str | None = None,
        bodies: str | Mapping[str, Any] | None = None,
        lubricant: str | Mapping[str, Any] | None = None,
        temperature: Any = None,
        folder: str | os.PathLike[str] = "",
        **keys: Any,
    ) -> None:
        keys.update(bodies=bodies, lubricant=lubricant, temperature=temperature)
        sections = {key: keys[key] for key in _SECTIONS if keys.get(key) is not None}
        if isinstance(sections.get("bodies"), str):
            sections["bodies"] = {"body_1": sections["bodies"], "body_2": sections["bodies"]}
        # A separate temperature is for a lubricant by name; in a table it is a key.
        if isinstance(lubricant, Mapping) and "temperature" not in lubricant and "temperature" in sections:
            sections["lubricant"] = {**lubricant, "temperature": sections.pop("temperature")}
        others = {key: value for key, value in keys.items() if key not in _SECTIONS}
        super().__init__(folder=folder, machine={"kind": kind, "designation": designation, **others}, **sections)


class Bearing(_MachineCase):
    """A rolling bearing under its loads: a :class:`Case` whose :meth:`~Case.solve` gives a :class:`MachineSolution`.

    Parameters
    ----------
    designation : str, optional
        A bearing of the catalogue, ``"6206"``, ``"NU 206"`` or ``"30206"``; without it give the dimensions as keywords (``balls``,
        ``ball_diameter``, ``pitch_diameter``, ...).
    kind : str, optional
        ``"ball-bearing"`` or ``"roller-bearing"``. By default that of the designation; without one, a bearing has rollers where a keyword
        begins with ``roller``, and balls elsewhere.
    bodies : str or mapping
        Material of rings and elements, ``"steel"``, or ``{"body_1": ..., "body_2": ...}`` with the rings as body 1 and the elements as
        body 2.
    lubricant : str or mapping
        A name of the database (:func:`fluids`), or the keys of ``[lubricant]``, such as ``{"iso_vg": 68, "base_oil": "mineral"}``.
    temperature : str or quantity
        Temperature of the film, where `lubricant` does not have it.
    folder : path, optional
        Folder of the files that the case names; the current one by default.
    **keys
        ``title``, ``surface_roughness``, ``inlet``, ``thermal``, ``mesh``, ``solver``, ``output``, ``curve``, ``compare`` and
        ``correlation`` are sections of the case, as for :class:`Case`. All other keywords are keys of ``[machine]``
        (docs/reference/case-file.md): ``radial_load="2 kN"``, ``axial_load="500 N"``, ``inner_ring_speed="3000 rpm"``,
        ``contamination_factor=0.5``, ... Quantities are strings with a unit, or pint quantities.

    Raises
    ------
    CaseError
        For an unknown designation (with those nearest to it), an unknown or missing key, a wrong unit, an impossible value.

    Examples
    --------
    >>> bearing = Bearing(
    ...     "6206",
    ...     radial_load="2 kN",
    ...     inner_ring_speed="3000 rpm",
    ...     bodies="steel",
    ...     lubricant={"iso_vg": 68, "base_oil": "mineral"},
    ...     temperature="70 degC",
    ... )
    >>> bearing.is_machine
    True
    """

    def __init__(self, designation: str | None = None, *, kind: str | None = None, **keys: Any) -> None:
        if kind is None and designation is None:
            kind = "roller-bearing" if any(key.startswith("roller") for key in keys) else "ball-bearing"
        super().__init__(kind=kind, designation=designation, **keys)


class GearPair(_MachineCase):
    """A pair of gears: a :class:`Case` of the teeth at one position.

    Parameters
    ----------
    kind : str
        ``"spur-gear"`` or ``"helical-gear"``.
    bodies : str or mapping
        Material of both gears, ``"steel"``, or ``{"body_1": ..., "body_2": ...}`` with the wheel as body 1 and the pinion as body 2.
    lubricant, temperature, folder
        As for :class:`Bearing`.
    **keys
        Sections of the case as for :class:`Bearing`, and the keys of ``[machine]`` (docs/reference/case-file.md): ``module="4 mm"``,
        ``pinion_teeth=20``, ``pinion_torque="100 N.m"``, ``position="pitch point"``, ...

    Raises
    ------
    CaseError
        For an unknown or missing key, a wrong unit, an impossible value.
    """

    def __init__(self, *, kind: str = "spur-gear", **keys: Any) -> None:
        super().__init__(kind=kind, **keys)


class Cam(_MachineCase):
    """A cam and its follower: a :class:`Case` of their contact.

    Parameters
    ----------
    kind : str
        Kind of the machine in the case file: ``"cam"``, with a flat, curved, roller or finger follower at one angle or over a turn, or
        ``"cam-and-flat-tappet"``, one contact from lift and acceleration.
    bodies : str or mapping
        Material of cam and follower, ``"steel"``, or ``{"body_1": ..., "body_2": ...}`` with the follower as body 1 and the cam as body 2.
    lubricant, temperature, folder
        As for :class:`Bearing`.
    **keys
        Sections of the case as for :class:`Bearing`, and the keys of ``[machine]`` (docs/reference/case-file.md): ``follower="flat"``,
        ``base_radius="15 mm"``, ``lift="8 mm"``, ``cam_speed="1000 rpm"``, ``angle="turn"``, ...

    Raises
    ------
    CaseError
        For an unknown or missing key, a wrong unit, an impossible value.
    """

    def __init__(self, *, kind: str = "cam", **keys: Any) -> None:
        super().__init__(kind=kind, **keys)

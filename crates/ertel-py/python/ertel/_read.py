"""Opens folders of results."""

from __future__ import annotations

import os
from pathlib import Path

from ._curve import Curve
from ._ertel import OutputError
from ._machine import MachineSolution
from ._result import Result
from ._transient import Transient
from ._studies import Comparison, MonteCarlo, Study

_FILES = "result.json, curve.json, transient.json, machine.json, comparison.json or study.json"


def read(
    folder: str | os.PathLike[str], *, inputs: str | os.PathLike[str] | None = None
) -> Result | Curve | Transient | MachineSolution | Comparison | MonteCarlo | Study:
    """Open a folder of results that the program or :meth:`Result.save` wrote.

    Nothing is solved, and nothing in the folder is changed. Fields, profiles, report and case are read when they are asked for.

    Parameters
    ----------
    folder : path
        The folder of a result, a curve, a course in time, a machine, a study (finished or not), samples of uncertain inputs, or a comparison.
    inputs : path, optional
        Folder of the files that the case names, where these are not next to its ``case.toml``.

    Returns
    -------
    Result, Curve, Transient, MachineSolution, Study, MonteCarlo or Comparison
        The content of a fresh solve, as far as the folder has it. Data of the solver are not stored: `save` is refused, and a solve with it as `start`
        begins at the dry contact.

    Raises
    ------
    OutputError
        A folder that is missing or holds no results, files that are missing or damaged, or of another version; the text names file and reason.
    """
    place = Path(folder)
    where = None if inputs is None else Path(inputs)
    if not place.is_dir():
        what = "it is a file, not the folder of results" if place.exists() else "no such result folder"
        raise OutputError(f"{place}: {what}")
    if (place / "result.json").exists():
        return Result._read(place, where)
    if (place / "curve.json").exists():
        return Curve._read(place, where)
    if (place / "transient.json").exists():
        return Transient._read(place, where)
    if (place / "machine.json").exists():
        return MachineSolution._read(place, where)
    if (place / "comparison.json").exists():
        return Comparison._read(place, where)
    if (place / "study.json").exists():
        return MonteCarlo._read(place, where) if (place / "monte-carlo.json").exists() else Study._read(place, where)
    if (place / "study" / "study.json").exists():
        raise OutputError(f"{place}: a comparison that was not finished; run it again, or read the study of its points in {place / 'study'}")
    raise OutputError(f"{place}: it holds no results of ertel: none of {_FILES}")

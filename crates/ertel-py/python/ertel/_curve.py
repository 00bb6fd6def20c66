"""Curves: a case at several values of one of its quantities."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _ertel
from ._stored import Tabulated, document, shaped

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ._case import Case


class Curve(Tabulated):
    """The points of a case with a ``[curve]``."""

    _native: _ertel.NativeCurve | None
    _table_file = "curve.csv"
    failures: list[tuple[int, str]]

    def __init__(self, case: Case, native: _ertel.NativeCurve) -> None:
        self._set_origin(case)
        self._native = native
        self._document = json.loads(native.document())
        self._table = native.table()
        self._report = native.report()
        self.failures = native.failures()

    @classmethod
    def _read(cls, folder: Path, inputs: Path | None) -> Curve:
        curve = cls.__new__(cls)
        curve._set_origin(None, folder, inputs)
        curve._native = None
        path = folder / "curve.json"
        curve._document = document(path, "ertel-curve", ("title", "quantity", "points"))
        points = curve._document["points"]
        curve.failures = shaped(path, lambda: [(i, point["reason"]) for i, point in enumerate(points) if not point["converged"]])
        return curve

    def plot(self, figure: str = "film_central") -> Figure:
        """Draw a figure over the quantity of the curve, in the colours of the program.

        Parameters
        ----------
        figure : str
            Name of the figure, as ``"film_central"`` or ``"friction_torque"``.

        Raises
        ------
        KeyError
            With the names that there are.
        """
        from ._plot import study_figure

        rows = self.to_pandas()
        axis = str(rows.columns[1])
        return study_figure(rows, [axis], figure, axis, self.title)

    def save(self, folder: str | os.PathLike[str]) -> Path:
        """Write the files of ``ertel solve``."""
        if self._native is None:
            raise self._refuse("the files of a curve")
        self._native.save(Path(folder))
        return Path(folder)

    def __len__(self) -> int:
        return len(self._document["points"])

    def __repr__(self) -> str:
        failed = f", {len(self.failures)} failed" if self.failures else ""
        return f"<ertel.Curve: {len(self)} points{failed}>"

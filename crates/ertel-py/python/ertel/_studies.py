"""Studies and comparisons that are on the disk."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _ertel
from ._ertel import OutputError
from ._machine import MachineSolution
from ._result import Result
from ._stored import Stored, document, frame, shaped, text_of
from ._transient import Transient

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure


class Study:
    """A study in its folder, finished or not.

    Attributes
    ----------
    folder : Path
        Where it is.
    title : str
        Its title, empty if there is none.
    axes : list of str
        Columns of the table that the study varies, with their units.
    n_points, n_finished : int
        Points of the study, and how many of them have been solved or have failed.
    n_damaged : int
        Lines of the journal that could not be read; their points count as not solved.
    failures : list of (int, str)
        Numbers, from 1, and reasons of the points that failed.
    """

    def __init__(self, folder: Path, about: dict[str, Any], table: str, inputs: Path | None = None) -> None:
        self.folder = folder
        # Folder of the files that the cases of the points name, where it is another one.
        self._inputs = inputs
        self.title: str = about["title"]
        self.axes: list[str] = about["columns"]
        self.n_points: int = about["n_points"]
        self.n_finished: int = about["n_finished"]
        self.n_damaged: int = about["n_damaged"]
        self.failures: list[tuple[int, str]] = [(number, reason) for number, reason in about["failures"]]
        self._table = table

    @classmethod
    def _read(cls, folder: Path, inputs: Path | None) -> Study:
        return cls(folder, *_study(folder), inputs)

    @property
    def table(self) -> str:
        """Content of ``results.csv``, written or not: a line for each finished point."""
        return self._table

    def to_pandas(self) -> pd.DataFrame:
        """The table of the finished points, SI, units in the titles of the columns."""
        return frame(self._table, str(self.folder / "results.csv"))

    def point(self, number: int) -> Result | Transient | MachineSolution:
        """The results of a point by its number, from 1; of a study that was run with ``folders=True``.

        Raises
        ------
        OutputError
            Where there is no folder of this point.
        """
        if not 1 <= number <= self.n_points:
            raise OutputError(f"{self.folder}: there is no point {number}; its points are 1 to {self.n_points}")
        place = self.folder / "points" / f"{number:0{len(str(self.n_points))}d}"
        if (place / "machine.json").exists():
            return MachineSolution._read(place, self._inputs)
        if (place / "transient.json").exists():
            return Transient._read(place, self._inputs)
        if (place / "result.json").exists():
            return Result._read(place, self._inputs)
        raise OutputError(f"{place}: no results of point {number}; run the study with folders=True, or `ertel sweep --folders`")

    def plot(self, figure: str = "film_central", x: str | None = None) -> Figure:
        """Draw a figure over an axis, with a curve for each combination of the others, in the colours of the program.

        Parameters
        ----------
        figure : str
            Name of the figure, as ``"film_central"`` or ``"friction_torque"``.
        x : str, optional
            Column of the axis, as in :attr:`axes`; by default the first one with different numbers.

        Raises
        ------
        KeyError
            With the names that there are.
        """
        from ._plot import study_figure

        return study_figure(self.to_pandas(), self.axes, figure, x, self.title)

    def __len__(self) -> int:
        return self.n_points

    def __repr__(self) -> str:
        failed = f", {len(self.failures)} failed" if self.failures else ""
        return f"<ertel.{type(self).__name__}: {self.n_finished} of {self.n_points} points{failed}>"


def _study(folder: Path) -> tuple[dict[str, Any], str]:
    about, table = _ertel.study_table(folder)
    return json.loads(about), table


@dataclass(frozen=True)
class Distribution:
    """How a figure varies over the samples, SI.

    Attributes
    ----------
    mean, standard, standard_error : float
        Mean, standard deviation, and the standard error of the latter.
    standard_of_first_order : float or None
        Standard deviation by the sensitivities, where they were computed.
    quantiles : dict of float to float
        Quantiles by their probability.
    correlations : dict of str to float
        Rank correlations with the inputs, by their keys.
    """

    mean: float
    standard: float
    standard_error: float
    standard_of_first_order: float | None
    quantiles: dict[float, float]
    correlations: dict[str, float]


class MonteCarlo(Study):
    """Samples of uncertain inputs: a study whose points are samples.

    Attributes
    ----------
    n_samples, n_solved : int
        Samples, and how many were solved.
    figures : dict of str to Distribution
        Distributions of the figures by their names.
    """

    n_samples: int
    n_solved: int
    figures: dict[str, Distribution]

    def plot(self, figure: str = "film_central", x: str | None = None) -> Figure:
        """Draw a figure over an uncertain input, a point for each sample.

        Parameters
        ----------
        figure : str
            Name of the figure, as ``"film_central"``.
        x : str, optional
            Column of the input, as in :attr:`axes`; by default the first one.

        Raises
        ------
        KeyError
            With the names that there are.
        """
        from ._plot import study_figure

        return study_figure(self.to_pandas(), self.axes, figure, x, self.title, is_scattered=True)

    @classmethod
    def _read(cls, folder: Path, inputs: Path | None) -> MonteCarlo:
        found = cls(folder, *_study(folder), inputs)
        path = folder / "monte-carlo.json"
        content = document(path, "ertel-monte-carlo", ("samples", "solved", "figures"))
        found.n_samples, found.n_solved, found.figures = shaped(path, lambda: _distributions(content))
        return found


def _distributions(content: dict[str, Any]) -> tuple[int, int, dict[str, Distribution]]:
    figures = {
        name: Distribution(**{**entry, "quantiles": {float(p): value for p, value in entry["quantiles"].items()}})
        for name, entry in content["figures"].items()
    }
    return content["samples"], content["solved"], figures


class Comparison(Stored):
    """Measured and computed figures, as :func:`compare` wrote them."""

    def __init__(self, folder: Path, inputs: Path | None, content: dict[str, Any]) -> None:
        self._set_origin(None, folder, inputs)
        self._document = content

    @classmethod
    def _read(cls, folder: Path, inputs: Path | None) -> Comparison:
        needed = ("title", "n_rows", "n_unsolved", "statistics", "rows")
        return cls(folder, inputs, document(folder / "comparison.json", "ertel-comparison", needed))

    @property
    def statistics(self) -> dict[str, Any]:
        """Bias, rms and so on of each figure, by its name."""
        return self._document["statistics"]

    @property
    def study(self) -> Study:
        """The study of its points."""
        assert self._folder is not None
        return Study._read(self._folder / "study", self._inputs)

    def to_pandas(self) -> pd.DataFrame:
        """A row for each measurement, as of :func:`compare`."""
        path = self._stored("the table") / "comparison.csv"
        return frame(text_of(path), str(path))

    def __len__(self) -> int:
        return self._document["n_rows"]

    def __repr__(self) -> str:
        return f"<ertel.Comparison: {len(self)} rows, {self._document['n_unsolved']} not solved>"

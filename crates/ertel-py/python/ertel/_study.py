"""Studies: a case at every point of axes over its inputs."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from . import _ertel, _toml
from ._case import Progress, _listener
from ._ertel import CaseError
from ._stored import frame, text_of

if TYPE_CHECKING:
    import pandas as pd


@dataclass(frozen=True)
class StudySummary:
    """Outcome of a study."""

    n_points: int
    n_kept: int
    n_new: int
    n_again: int
    n_damaged: int
    n_unresolved: int
    interrupted: bool
    wall_seconds: float
    point_seconds: float
    failures: list[dict[str, Any]] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)

    @classmethod
    def _read(cls, text: str) -> StudySummary:
        return cls(**json.loads(text))


def sweep(
    study: str | os.PathLike[str] | Mapping[str, Any],
    folder: str | os.PathLike[str] | None = None,
    *,
    jobs: int | None = None,
    threads: int | None = None,
    folders: bool = False,
    retry: bool = False,
    progress: Progress = None,
) -> pd.DataFrame:
    """Solve every point of a study file, as ``ertel sweep`` does, and return its table.

    Finished points are kept in `folder`: the same call continues a run that was stopped. The outcome of
    the run is in ``table.attrs["summary"]``, a dict with the names of :class:`StudySummary`.

    Parameters
    ----------
    study : path or mapping
        The study file (docs/guide/studies.md), or its keys, as ``{"case": "base.toml", "axis": [{"key": ..., "values": [...]}]}``, with a
        `folder`.
    folder : path, optional
        Where journal and table go; ``results/<name of the study>`` by default.
    jobs, threads : int, optional
        Points solved at the same time (as many as cores), and threads of each (one).
    folders : bool
        Whether the results of each point are written into a separate folder.
    retry : bool
        Whether points that failed before are solved again.
    progress : bool or callable, optional
        As in :meth:`Case.solve`.

    Returns
    -------
    pandas.DataFrame
        A row for each point, SI, units in the titles of the columns; points that failed have their reason.
    """
    if isinstance(study, Mapping):
        if folder is None:
            raise CaseError("a study of keys has no name: give the folder of its results")
        with tempfile.TemporaryDirectory(prefix="ertel-") as place:
            path = Path(place) / "study made in Python.toml"
            # Without a study file, paths are relative to the current folder.
            named = {key: _absolute(key, study[key]) for key in ("case", "points") if key in study}
            path.write_text(_toml.text({**study, **named}), encoding="utf-8")
            return sweep(
                path, folder, jobs=jobs, threads=threads, folders=folders, retry=retry, progress=progress
            )
    path = Path(study)
    target = Path("results") / path.stem if folder is None else Path(folder)
    text = _ertel.sweep(
        path, target, jobs=jobs, threads=threads, folders=folders, retry=retry, progress=_listener(progress)
    )
    return table(target, StudySummary._read(text))


def _absolute(key: str, path: Any) -> str:
    if not isinstance(path, (str, os.PathLike)):
        raise CaseError(f"`{key}` of a study is the path of a file, not a {type(path).__name__}")
    return os.fsdecode(os.path.abspath(path))


def table(folder: Path, summary: StudySummary) -> pd.DataFrame:
    """The table of a study that was run."""
    path = folder / "results.csv"
    rows = frame(text_of(path), str(path))
    # As plain data: tables with others cannot be written as Parquet.
    rows.attrs["summary"] = asdict(summary)
    return rows


def compare(
    case: str | os.PathLike[str],
    measured: str | os.PathLike[str],
    folder: str | os.PathLike[str] | None = None,
    *,
    ignore: Sequence[str] = (),
    columns: Mapping[str, str] | None = None,
    decimal: Literal["point", "comma"] | None = None,
    jobs: int | None = None,
    progress: Progress = None,
) -> pd.DataFrame:
    """Solve a case at the points of a table of measured films or tractions, or of torques and losses of a machine, as ``ertel compare`` does.

    Parameters
    ----------
    case, measured : path
        The case file, and the table or the export of a rig (docs/guide/compare.md).
    folder : path, optional
        Where table, picture and report go; ``results/<case>-<table>`` by default. The same call continues a run that was stopped.
    ignore : sequence of str
        Columns of the table to ignore.
    columns : mapping of str to str, optional
        Columns by quantity where their titles do not say it: ``{"film": "Film (nm)"}``, with a unit ``{"film": "Film:nm"}``, by number
        ``{"film": "#3"}``.
    decimal : {"point", "comma"}, optional
        The decimal mark; by default that of the cells.
    jobs, progress : optional
        As in :func:`sweep`.

    Returns
    -------
    pandas.DataFrame
        A row for each measurement: measured and computed figures, error bars, relative differences (SI). ``attrs["report"]`` has bias, rms,
        the worst row and how many agree within the uncertainty, in words.
    """
    case, measured = Path(case), Path(measured)
    target = Path("results") / f"{case.stem}-{measured.stem}" if folder is None else Path(folder)
    report, text = _ertel.compare(
        case,
        measured,
        target,
        ignored=list(ignore),
        columns=list((columns or {}).items()),
        decimal=decimal,
        jobs=jobs,
        progress=_listener(progress),
    )
    path = target / "comparison.csv"
    rows = frame(text_of(path), str(path))
    rows.attrs.update(report=report, summary=asdict(StudySummary._read(text)))
    return rows


def merge(target: str | os.PathLike[str], parts: Sequence[str | os.PathLike[str]]) -> StudySummary:
    """Join the parts of a study, as ``ertel sweep --merge`` does, into the folder `target`."""
    return StudySummary._read(_ertel.merge(Path(target), [Path(part) for part in parts]))

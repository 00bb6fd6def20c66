"""Studies on a cluster, with Dask (https://distributed.dask.org).

Any cluster that Dask reaches will do: ``LocalCluster``, SLURM and others by dask-jobqueue, Kubernetes by dask-kubernetes.
"""

from __future__ import annotations

import os
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _ertel
from ._case import Progress, _listener
from ._ertel import CaseError
from ._study import StudySummary, table

if TYPE_CHECKING:
    import pandas as pd
    from distributed import Client

__all__ = ["sweep"]

# Points of a task, at most: some seconds to minutes, and little that a lost worker loses.
MOST_POINTS_PER_TASK = 200
# Tasks for each thread of the workers, at the least, so that none waits long for the last one.
TASKS_PER_THREAD = 4

Group = tuple[list[int], list[int | None], list[int]]


def sweep(
    study: str | os.PathLike[str],
    client: Client,
    folder: str | os.PathLike[str] | None = None,
    *,
    points_per_task: int | None = None,
    retries: int = 5,
    retry: bool = False,
    progress: Progress = None,
) -> pd.DataFrame:
    """Solve every point of a study file on the workers of a Dask cluster, and return its table.

    A task is a part of neighbours, in the order in which points start from each other. A part whose points start from those of another one
    solves these again: the table is that of :func:`ertel.sweep`, digit for digit, for any tasks and workers. Finished parts go into the
    journal in `folder` as they arrive: a task whose worker is lost is given to another, and the same call,
    or ``ertel sweep``, continues a run that was stopped.

    Parameters
    ----------
    study : path
        The study file; it and the files that it names are sent to the workers.
    client : distributed.Client
        Client of the cluster. ertel must be installed on the workers, in the same version.
    folder : path, optional
        Where journal and table go; ``results/<name of the study>`` by default.
    points_per_task : int, optional
        Points of a task, at most; by default 200, and fewer where the workers would wait for each other.
    retries : int
        How often a task is tried again when its worker is lost.
    retry : bool
        Whether points that failed before are solved again.
    progress : bool or callable, optional
        True prints a line for each finished part; a callable is called with a dict for each.

    Returns
    -------
    pandas.DataFrame
        As of :func:`ertel.sweep`.

    Raises
    ------
    CaseError
        For a bad study, before anything is sent.
    """
    from distributed import as_completed

    path = Path(study)
    target = Path("results") / path.stem if folder is None else Path(folder)
    native = _ertel.NativeStudy(path)
    most = _points_per_task(native.n_points, points_per_task, client)
    n_finished = native.open(target, retry)
    try:
        parts = native.parts(most)
        futures = []
        if parts:
            bundle, name = _bundle(path, [Path(file) for file in native.files])
            files = client.scatter(bundle, broadcast=True, hash=False)
            groups: dict[int, Any] = {}
            for group, start, stop in parts:
                if group not in groups:
                    groups[group] = client.scatter(native.group(group), hash=False)
                futures.append(
                    client.submit(_solve_part, name, files, groups[group], (start, stop), retries=retries, pure=False)
                )
        try:
            for future in as_completed(futures):
                n_finished += native.append(future.result())
                future.release()
                _report(progress, {"event": "part", "n_finished": n_finished, "n_points": native.n_points})
        finally:
            client.cancel(futures)
    finally:
        native.close()
    # All that is left is the table; points that another run has taken away in the meantime are solved here.
    text = _ertel.sweep(path, target, progress=_listener(None))
    return table(target, StudySummary._read(text))


def _points_per_task(n_points: int, wanted: int | None, client: Client) -> int:
    if wanted is not None:
        if wanted < 1:
            raise CaseError(f"points_per_task = {wanted}: one at least")
        return wanted
    n_threads = sum(client.nthreads().values()) or 1
    return max(1, min(MOST_POINTS_PER_TASK, n_points // (TASKS_PER_THREAD * n_threads)))


def _bundle(study: Path, files: list[Path]) -> tuple[dict[str, bytes], str]:
    """The files of a study by their paths from their common folder, and the study's among them."""
    absolute = [Path(os.path.abspath(file)) for file in {study, *files}]
    common = Path(os.path.commonpath([str(file.parent) for file in absolute]))
    contents = {str(file.relative_to(common)): file.read_bytes() for file in absolute}
    return contents, str(Path(os.path.abspath(study)).relative_to(common))


def _solve_part(name: str, files: dict[str, bytes], group: Group, part: tuple[int, int]) -> str:
    """On a worker: solve a part in a separate folder, and send back its journal."""
    with tempfile.TemporaryDirectory(prefix="ertel-") as place:
        inputs, results = Path(place) / "inputs", Path(place) / "results"
        for file, contents in files.items():
            (inputs / file).parent.mkdir(parents=True, exist_ok=True)
            (inputs / file).write_bytes(contents)
        return _ertel.solve_part(inputs / name, results, group, part)


def _report(progress: Progress, event: dict[str, Any]) -> None:
    if progress is True:
        print(f"{event['n_finished']} of {event['n_points']} points", flush=True)
    elif callable(progress):
        progress(event)

#!/usr/bin/env python3
"""Runs the notebooks and keeps their outputs, with a mark of the cells that gave them. Needs ertel[all], nbclient and ipykernel.

    python crates/ertel-py/notebooks/run.py [NAME...]
"""

from __future__ import annotations

import hashlib
import os
import sys
import tempfile
from pathlib import Path
from typing import Any

import nbformat
from nbclient import NotebookClient

HERE = Path(__file__).resolve().parent


def mark(notebook: Any) -> str:
    """Of the text of all cells that run."""
    cells = [cell.source for cell in notebook.cells if cell.cell_type == "code"]
    return hashlib.sha256("\0".join(cells).encode()).hexdigest()


def run(path: Path) -> Any:
    """The notebook with the outputs of a run in a folder that has nothing but a link to the repository, so that outputs contain no other path."""
    notebook = nbformat.read(path, as_version=4)
    os.environ["ERTEL_CASES"] = "repository/cases"
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "repository").symlink_to(HERE.parents[2])
        NotebookClient(notebook, timeout=600, resources={"metadata": {"path": folder}}).execute()
    for cell in notebook.cells:
        # Times of the run.
        cell.metadata.pop("execution", None)
    notebook.metadata["language_info"] = {"name": "python"}
    notebook.metadata["ertel"] = {"cells": mark(notebook)}
    return notebook


def main() -> None:
    names = sys.argv[1:]
    for path in sorted(HERE.glob("*.ipynb")):
        if not names or path.stem in names:
            nbformat.write(run(path), path)
            print(path.name, path.stat().st_size)


if __name__ == "__main__":
    main()

"""Folders of results: their files, read when they are asked for."""

from __future__ import annotations

import base64
import binascii
import csv
import io
import json
import xml.etree.ElementTree as ET
import zlib
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _ertel
from ._ertel import CaseError, OutputError
from ._former import with_new_columns, with_new_names

if TYPE_CHECKING:
    import pandas as pd

    from ._case import Case

Floats = NDArray[np.float64]

# Versions of the layout of JSON files that are read here, the newest last.
FORMAT_VERSIONS = (1, 2)


class Stored:
    """A result of this process, or read from a folder."""

    _document: dict[str, Any]
    # Texts of this process; None where they are in files of the folder.
    _report: str | None = None
    _case: Case | None
    _folder: Path | None
    # Folder of the files that the case names, where it is another one.
    _inputs: Path | None

    @property
    def case(self) -> Case:
        """The case that was solved. Of a folder it is read from its ``case.toml``.

        Raises
        ------
        CaseError
            If this version cannot read it, for example if its files are elsewhere: give their folder to :func:`ertel.read`.
        """
        if self._case is None:
            from ._case import Case

            assert self._folder is not None
            text = text_of(self._folder / "case.toml")
            name = str(self._folder / "case.toml")
            try:
                self._case = Case.from_text(text, name=name, folder=self._inputs or self._folder)
            except CaseError as error:
                advice = "" if self._inputs else "\nIf it names files, give their folder: ertel.read(folder, inputs=...)"
                raise CaseError(f"{error}{advice}") from None
        return self._case

    @property
    def folder(self) -> Path | None:
        """The folder that it was read from; None of what was solved in this process."""
        return self._folder

    @property
    def report(self) -> str:
        """The report that ``ertel solve`` shows."""
        if self._report is None:
            self._report = text_of(self._stored("the report") / "report.txt")
        return self._report

    @property
    def title(self) -> str:
        """Title of the case, empty if there is none."""
        return self._document["title"]

    def to_dict(self) -> dict[str, Any]:
        """Content of the JSON document, such as ``result.json``: figures, inputs and statistics in SI."""
        return self._document

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_native": None}

    def _stored(self, what: str) -> Path:
        if self._folder is None:
            raise self._refuse(what)
        return self._folder

    def _set_origin(self, case: Case | None, folder: Path | None = None, inputs: Path | None = None) -> None:
        self._case, self._folder, self._inputs = case, folder, inputs

    def _refuse(self, what: str) -> Exception:
        if self._folder is not None:
            return OutputError(f"{what}: this was read from {self._folder}, which has the files already; solve its case again: .case.solve()")
        return RuntimeError(f"{what}: only in the process that solved the case; this result was pickled")


class Warned:
    """Warnings of a result."""

    _document: dict[str, Any]

    @property
    def warnings(self) -> list[str]:
        """Warnings about the result, one sentence each; in whole machines, those of failed contacts first."""
        return list(self._document["warnings"])

    @property
    def warning_codes(self) -> list[str]:
        """The codes of :attr:`warnings`, one each; :func:`ertel.explain` explains them. Empty for results of older versions."""
        return list(self._document.get("warning_codes", []))


class Tabulated(Stored):
    """The same with a table: a line for each of its points or contacts."""

    _table: str | None = None
    # Name of its file.
    _table_file: str

    @property
    def table(self) -> str:
        """The table as CSV: a line for each point or contact, units in the titles of the columns."""
        if self._table is None:
            self._table = with_new_columns(text_of(self._stored("the table") / self._table_file))
        return self._table

    def to_pandas(self) -> pd.DataFrame:
        """The table, units in the titles of the columns."""
        return frame(self.table, "the table" if self._folder is None else str(self._folder / self._table_file))


def text_of(path: Path) -> str:
    """The text of a file of a folder.

    Raises
    ------
    OutputError
        Naming file and reason.
    """
    try:
        return path.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise OutputError(f"{path}: the folder does not have this file; solve the case again to write it") from None
    except UnicodeDecodeError:
        raise OutputError(f"{path}: it is no UTF-8 text; the file is damaged") from None
    except OSError as error:
        raise OutputError(f"{path}: cannot be read: {error.strerror}") from None


def frame(text: str, name: str) -> pd.DataFrame:
    """A table of the program.

    Raises
    ------
    OutputError
        Of what is no such table, by its name.
    """
    import pandas as pd

    try:
        # Versions of pandas differ in the rows that they accept.
        head, *rows = csv.reader(io.StringIO(text), strict=True)
        for row in rows:
            if row and len(row) != len(head):
                raise ValueError(f"a row has {len(row)} cells, the head {len(head)}")
        return pd.read_csv(io.StringIO(text))
    except (ValueError, csv.Error) as error:  # EmptyDataError and ParserError of pandas are a ValueError.
        raise OutputError(f"{name}: damaged, it is no table: {str(error).strip()}") from None


def document(path: Path, format: str, needed: tuple[str, ...]) -> dict[str, Any]:
    """A JSON file of the program, of this format and with these keys.

    Raises
    ------
    OutputError
        A file that is missing, damaged, of another format or version, or lacks keys.
    """
    try:
        content = json.loads(text_of(path), parse_constant=_refuse_constant)
    except ValueError as error:
        raise OutputError(f"{path}: damaged, it is no JSON: {error}") from None
    except RecursionError:
        raise OutputError(f"{path}: damaged, it is nested too deeply") from None
    if isinstance(content, dict) and "format" not in content and set(needed) <= set(content):
        raise OutputError(f"{path}: it has no `format`: an older ertel wrote it; run the same again to replace it")
    if not isinstance(content, dict) or content.get("format") != format:
        raise OutputError(f'{path}: it is no file of ertel with "format": "{format}"')
    if "format_version" not in content:
        raise OutputError(f"{path}: it has no `format_version`; it is damaged, or from an older ertel: solve the case again")
    version = content["format_version"]
    if version not in FORMAT_VERSIONS:
        by = content.get("ertel_version", "another version")
        known = " and ".join(map(str, FORMAT_VERSIONS))
        raise OutputError(
            f"{path}: its layout is version {version}, written by ertel {by}; ertel {_ertel.__version__} reads versions {known}"
        )
    if version == 1:
        content = with_new_names(content)
    missing = [key for key in needed if key not in content]
    if missing:
        raise OutputError(
            f"{path}: it has no {', '.join(f'`{key}`' for key in missing)}; it is damaged, or from an older ertel: solve the case again"
        )
    return content


def _refuse_constant(name: str) -> None:
    raise ValueError(f"{name} is no number of JSON")


def shaped(path: Path, read: Any) -> Any:
    """The result of `read` for a document that may be damaged."""
    try:
        return read()
    except (KeyError, TypeError, ValueError, AttributeError, IndexError, StopIteration) as error:
        raise OutputError(f"{path}: damaged, its content is not that of a result ({type(error).__name__}: {error})") from None


def columns(path: Path) -> dict[str, Floats]:
    """The columns of a CSV file of numbers; empty fields are not a number."""
    try:
        rows = list(csv.reader(line for line in text_of(path).splitlines() if line))
    except csv.Error as error:
        raise OutputError(f"{path}: damaged, it is no table: {error}") from None
    if len(rows) < 2 or any(len(row) != len(rows[0]) for row in rows):
        raise OutputError(f"{path}: damaged, it has no rows or rows of different lengths")
    try:
        values = np.array([[float(field) if field else np.nan for field in row] for row in rows[1:]])
    except ValueError as error:
        raise OutputError(f"{path}: damaged, {error}") from None
    return {name: values[:, i].copy() for i, name in enumerate(rows[0])}


_TYPES = {"Float32": "<f4", "Float64": "<f8", "Int64": "<i8", "UInt8": "u1"}
_CORNERS = {3: 2, 5: 3, 9: 4}


def surface(path: Path) -> tuple[Floats, NDArray[np.uint32], dict[str, Floats]]:
    """Points (m), cells and fields of ``surface.vtu`` or of an instant, fields by their names in Python."""
    try:
        root = ET.fromstring(text_of(path))
    except ET.ParseError as error:
        raise OutputError(f"{path}: damaged, it is no XML: {error}") from None
    try:
        arrays = {
            str(array.get("Name")): (section, _array(array, root.get("compressor")))
            for section in ("Points", "Cells", "PointData")
            for array in root.findall(f"./UnstructuredGrid/Piece/{section}/DataArray")
        }
        points = arrays["Points"][1].reshape(-1, 3)[:, :2].copy()
        kinds = set(arrays["types"][1].tolist())
        (kind,) = kinds
        cells = arrays["connectivity"][1].reshape(-1, _CORNERS[kind])
        if cells.min() < 0 or cells.max() >= len(points):
            raise ValueError("a cell has a corner that is no point")
        fields = {}
        for column, (section, values) in arrays.items():
            if section == "PointData":
                if len(values) != len(points):
                    raise ValueError(f"{column} has another number of values than points")
                fields[_field_of(column)] = values.astype(np.float64)
    except (KeyError, ValueError, TypeError, binascii.Error, zlib.error) as error:
        raise OutputError(f"{path}: damaged, or not written by ertel ({type(error).__name__}: {error})") from None
    return points, cells.astype(np.uint32), fields


def collection(path: Path) -> list[tuple[float, Path]]:
    """Times (s) and files of a collection of ParaView."""
    try:
        sets = ET.fromstring(text_of(path)).findall("./Collection/DataSet")
        return [(float(found.attrib["timestep"]), path.parent / found.attrib["file"]) for found in sets]
    except (ET.ParseError, KeyError, ValueError) as error:
        raise OutputError(f"{path}: damaged, or not written by ertel ({type(error).__name__}: {error})") from None


def _field_of(column: str) -> str:
    """The name of a field by that of its array, which ends in the unit."""
    names = [name for name, _, _ in _ertel.field_names() if column == name or column.startswith(name + "_")]
    if not names:
        raise ValueError(f"no field is called {column}")
    return max(names, key=len)


def _array(element: ET.Element, compressor: str | None) -> NDArray[Any]:
    text = (element.text or "").strip()
    if element.get("format") != "binary" or compressor not in (None, "vtkZLibDataCompressor"):
        raise ValueError(f"the array {element.get('Name')} has another format")
    data = _whole(base64.b64decode(text, validate=True)) if compressor is None else _inflated(text)
    if data is None:
        raise ValueError(f"the array {element.get('Name')} is cut off")
    return np.frombuffer(data, dtype=_TYPES[str(element.get("type"))])


def _whole(data: bytes) -> bytes | None:
    """An array behind its length in bytes, as before version 0.1.0."""
    n_bytes = int.from_bytes(data[:8], "little")
    return data[8:] if len(data) == 8 + n_bytes else None


def _inflated(text: str) -> bytes | None:
    """An array in blocks of zlib: their number, size, that of the last one, and their lengths; then they themselves."""
    n_blocks, size, last = np.frombuffer(base64.b64decode(text[:32], validate=True), "<u8")
    n_header = 4 * -(-(3 + int(n_blocks)) * 8 // 3)
    header = np.frombuffer(base64.b64decode(text[:n_header], validate=True), "<u8")
    blocks = base64.b64decode(text[n_header:], validate=True)
    ends = np.cumsum(header[3:])
    if len(blocks) != (ends[-1] if n_blocks else 0):
        return None
    data = b"".join(zlib.decompress(blocks[int(end - length) : int(end)]) for end, length in zip(ends, header[3:], strict=True))
    full = int(n_blocks) - (1 if last else 0)
    return data if len(data) == full * int(size) + int(last) else None

#!/usr/bin/env python3
"""Contacts with converged values, for comparison with any program. Needs Python 3.9 and no packages.

    benchmark.py compare RESULTS.csv                 compares results with the values of this suite
    benchmark.py run [--program ERTEL]               solves the cases with ertel, and prints results in this format
    benchmark.py values [--program ERTEL]            computes values.csv again, by both methods of ertel
"""

import argparse
import csv
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

SUITE = Path(__file__).parent
VALUES = SUITE / "values.csv"
# Names in result.json, and their SI units.
FIGURES = {
    "film_central": "m",
    "film_minimum": "m",
    "pressure_central": "Pa",
    "traction_coefficient": "",
    "traction_coefficient_body_1": "",
    "film_temperature_maximum": "K",
}
# Target errors of both films. Elements reach theirs within the default number of unknowns.
METHODS = {"finite-volumes": "0.05 %", "finite-elements": "0.2 %"}


def cases():
    """Names of the cases in alphabetical order."""
    return sorted(path.stem for path in (SUITE / "cases").glob("*.toml"))


def solve(program, case, method):
    """Figures of a case by ertel: value and error in SI units by name. Figures that are zero or not resolved are left out."""
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "solve", str(SUITE / "cases" / f"{case}.toml"), "--quiet", "--output", f"{folder}/result"]
        command += ["--set", f"solver.method={method}", "--set", f"mesh.target_error={METHODS[method]}"]
        ended = subprocess.run(command, capture_output=True, text=True)
        if ended.returncode != 0:
            sys.exit(f"error: {case} by {method}: {ended.stderr}")
        figures = json.loads(Path(f"{folder}/result/result.json").read_text())["figures"]
    found = {name: figures[name] for name in FIGURES if name in figures}
    return {name: (of["value"], of["error"]) for name, of in found.items() if of["resolved"] and of["value"] != 0.0}


def run(program):
    """Prints results of ertel by finite volumes."""
    out = csv.writer(sys.stdout, lineterminator="\n")
    out.writerow(["case", "figure", "value", "error"])
    for case in cases():
        for name, (value, error) in solve(program, case, "finite-volumes").items():
            out.writerow([case, name, f"{value:.7g}", f"{error:.2g}"])


def values(program):
    """Writes values.csv: figures that both methods resolve."""
    with VALUES.open("w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["case", "figure", "unit", *[f"{of}{end}" for of in ("volumes", "elements") for end in ("", "_error")]])
        for case in cases():
            one, two = (solve(program, case, method) for method in METHODS)
            for name in (name for name in FIGURES if name in one and name in two):
                row = [f"{x:.7g}" if i == 0 else f"{x:.2g}" for of in (one, two) for i, x in enumerate(of[name])]
                out.writerow([case, name, FIGURES[name], *row])
                print(case, name, *row, flush=True)


def read_results(path, known):
    """Value and error by case and figure; ends with exit code 2 and the line where the table is invalid."""

    def refuse(line, reason):
        print(f"error: {path}:{line}: {reason}", file=sys.stderr)
        sys.exit(2)

    found = {}
    try:
        with open(path, newline="", encoding="utf-8-sig") as file:
            table = csv.DictReader(file)
            missing = [name for name in ("case", "figure", "value") if name not in (table.fieldnames or [])]
            if missing:
                refuse(1, f"missing column `{missing[0]}`: the columns are case, figure, value and optionally error")
            for row in table:
                at = (row["case"], row["figure"])
                if at not in known:
                    refuse(table.line_num, f"no figure `{at[1]}` of a case `{at[0]}` in this suite; see values.csv")
                if at in found:
                    refuse(table.line_num, f"`{at[1]}` of `{at[0]}` is given twice")
                try:
                    numbers = float(row["value"]), float(row.get("error") or 0.0)
                except (TypeError, ValueError):
                    refuse(table.line_num, "value and error must be numbers in SI units")
                if not all(map(math.isfinite, numbers)) or numbers[1] < 0.0:
                    refuse(table.line_num, "value and error must be finite, and the error not negative")
                found[at] = numbers
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        refuse(1, error)
    return found


def compare(results):
    """Prints the difference of each result from both methods; returns whether all lie within the bars."""
    with VALUES.open(newline="") as file:
        expected = list(csv.DictReader(file))
    mine = read_results(results, {(row["case"], row["figure"]) for row in expected})
    print(f"{'case':18} {'figure':28} {'result':>13} {'volumes':>10} {'elements':>12}")
    outside = 0
    for row in expected:
        own = mine.get((row["case"], row["figure"]))
        if own is None:
            continue
        value, error = own
        methods = ("volumes", "elements")
        off = [value / float(row[of]) - 1.0 for of in methods]
        within = any(abs(value - float(row[of])) <= error + float(row[f"{of}_error"]) for of in methods)
        outside += not within
        print(f"{row['case']:18} {row['figure']:28} {value:13.6g} {off[0]:+10.3%} {off[1]:+12.3%}   {'within the bars' if within else 'OUTSIDE'}")
    print(f"{len(mine)} of {len(expected)} figures compared, {outside} outside the bars")
    return outside == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("compare").add_argument("results")
    for name in ("run", "values"):
        commands.add_parser(name).add_argument("--program", default="ertel")
    given = parser.parse_args()
    if given.command == "compare":
        sys.exit(0 if compare(given.results) else 1)
    {"run": run, "values": values}[given.command](given.program)


if __name__ == "__main__":
    main()

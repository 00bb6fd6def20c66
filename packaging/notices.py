#!/usr/bin/env python3
"""Writes THIRD_PARTY_NOTICES.txt: third-party works in the program, the Python package and the web page, with their licences.

Crates and their licence texts are those of Cargo.lock; `cargo fetch` downloads missing ones first. Run it after a change of Cargo.lock:

    packaging/notices.py
"""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FILE = ROOT / "THIRD_PARTY_NOTICES.txt"
SHIPPED = ["ertel-cli", "ertel-py", "ertel-web"]
HEADS = ("LICEN", "COPYING", "NOTICE", "UNLICENSE", "COPYRIGHT")
# Shipped in addition to the crates, or within a crate under a licence that the crate does not name: name, licence, its text.
OTHERS = [
    ("Liberation fonts, as Ertel Sans (crates/ertel-plot/assets/fonts)", "OFL-1.1", "crates/ertel-plot/assets/fonts/OFL.txt"),
    ("uPlot (crates/ertel/src/output/html/assets/uplot)", "MIT", "crates/ertel/src/output/html/assets/uplot/LICENSE"),
]


CARGO = os.environ.get("CARGO", "cargo")


def cargo(*arguments: str) -> str:
    command = [CARGO, *arguments, "--offline", "--locked"]
    return subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout


def linked() -> set[tuple[str, str]]:
    """Name and version of the crates that are linked on some platform, without those that only build or test."""
    packages = [word for name in SHIPPED for word in ("--package", name)]
    tree = cargo("tree", *packages, "--edges", "normal", "--target", "all", "--prefix", "none", "--format", "{p}")
    crates = (line.split()[:2] for line in tree.splitlines() if line.strip())
    return {(name, version.removeprefix("v")) for name, version in crates}


def texts(folder: Path, licence: str) -> tuple[list[str], bool]:
    """Licence files of a crate, also those of sources of others within it, and whether one is its own; where MIT is a choice, that of MIT alone."""
    found = [path for path in sorted(folder.rglob("*")) if path.name.upper().startswith(HEADS) and path.is_file()]
    found = [path for path in found if path.suffix in ("", ".md", ".txt", ".html", ".TXT") or path.suffix[1:].isupper()]
    choices = {choice.strip(" ()") for choice in licence.replace("/", " OR ").split(" OR ")}
    if "MIT" in choices and " AND " not in licence and any("MIT" in path.name.upper() for path in found):
        found = [path for path in found if not any(other in path.name.upper() for other in ("APACHE", "ZLIB", "0BSD", "UNLICENSE", "LGPL"))]
    has_own = any(path.parent == folder for path in found)
    lines = (path.read_text(encoding="utf-8", errors="replace").splitlines() for path in found)
    return ["\n".join(line.rstrip() for line in text).strip() for text in lines], has_own


def main() -> None:
    # Also the crates of other platforms, which a local build omits.
    subprocess.run([CARGO, "fetch", "--locked", "--quiet"], cwd=ROOT, check=True)
    crates = linked()
    packages = json.loads(cargo("metadata", "--format-version", "1"))["packages"]
    mit = "Permission" + (ROOT / "LICENSE-MIT").read_text(encoding="utf-8").split("Permission", 1)[1].strip()
    table: list[str] = []
    by_words: dict[str, tuple[str, list[str]]] = {}
    for package in sorted(packages, key=lambda package: (package["name"], package["version"])):
        name = f"{package['name']} {package['version']}"
        if package["source"] is None or (package["name"], package["version"]) not in crates:
            continue
        licence = package["license"]
        table.append(f"{name:<34} {licence}")
        own, has_own = texts(Path(package["manifest_path"]).parent, licence)
        if not has_own:
            if "MIT" not in licence:
                raise SystemExit(f"{name}: no licence text in its package, and {licence} is not MIT")
            authors = ", ".join(author.split(" <")[0] for author in package["authors"]) or f"the authors of {package['name']}"
            own += [f"MIT License\n\nCopyright (c) {authors}\n\n{mit}"]
        for text in own:
            # The same words in other lines are the same text.
            by_words.setdefault(" ".join(text.split()), (text, []))[1].append(name)
    for name, licence, path in OTHERS:
        table.append(f"{name}: {licence}")
        text = (ROOT / path).read_text(encoding="utf-8").strip()
        by_words.setdefault(" ".join(text.split()), (text, []))[1].append(name)
    rule = "=" * 100
    head = (
        "Third-party notices of ertel\n\n"
        "The program, the Python package and the web page contain the following third-party works, each under its own licence.\n"
        "Made by packaging/notices.py from Cargo.lock.\n"
    )
    parts = [f"{rule}\nFor: {', '.join(dict.fromkeys(names))}\n{rule}\n\n{text}\n" for text, names in by_words.values()]
    FILE.write_text("\n".join([head, *table, "", *parts]), encoding="utf-8")
    print(f"{FILE.name}: {len(table)} works, {len(by_words)} texts")


main()

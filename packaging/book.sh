#!/usr/bin/env bash
# The documentation as a site:  packaging/book.sh FOLDER
#
# mdBook is installed below target, where it is missing.
set -euo pipefail
folder=$(realpath -m "${1:?error: packaging/book.sh needs the folder to write}")
cd "$(dirname "$0")/.."
target=$PWD/target
test -x "$target/tools/bin/mdbook" || cargo install --quiet --locked --root "$target/tools" --target-dir "$target/tools/target" mdbook@0.5.4
"$target/tools/bin/mdbook" build --dest-dir "$folder" > /dev/null

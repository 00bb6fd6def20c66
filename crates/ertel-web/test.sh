#!/usr/bin/env bash
# Builds module, page and program, and compares them: in node, and in Chromium where there is one.
set -euo pipefail
cd "$(dirname "$0")"
./build.sh
(cd ../.. && cargo build --release --bin ertel)
node tests/node.mjs
if command -v "${CHROMIUM:-chromium}" > /dev/null; then
  node tests/browser.mjs
else
  echo "no Chromium: the page itself was not tested"
fi

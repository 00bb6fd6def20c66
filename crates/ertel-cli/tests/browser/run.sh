#!/usr/bin/env bash
# Tests of the pages in headless Chromium: of the system, or installed where that is allowed (root on Debian).
# ERTEL is the program [default: target/release/ertel]; screenshots are left in target/browser.
set -euo pipefail
here="$(cd "$(dirname "$0")" && pwd)"
target="${CARGO_TARGET_DIR:-$here/../../../../target}"
mkdir -p "$target/browser"
target="$(cd "$target" && pwd)"
export ERTEL="${ERTEL:-$target/release/ertel}"
export SCREENSHOTS="$target/browser"
find_browser() { command -v chromium || command -v chromium-browser || command -v google-chrome || true; }
export CHROMIUM="${CHROMIUM:-$(find_browser)}"
if [ -z "$CHROMIUM" ] && [ "$(id -u)" = 0 ] && command -v apt-get > /dev/null; then
  apt-get update -qq && apt-get install -y -qq chromium > /dev/null
  CHROMIUM="$(find_browser)"
fi
if [ -z "$CHROMIUM" ]; then
  echo "no Chromium: install the package chromium, or set CHROMIUM" >&2
  exit 1
fi
# Packages go to the target folder: the source tree stays as it is.
cp "$here"/package.json "$here"/package-lock.json "$here"/*.mjs "$SCREENSHOTS/"
cd "$SCREENSHOTS"
npm ci --silent --no-audit --no-fund
CASES="$here/../../../../cases" npm test --silent

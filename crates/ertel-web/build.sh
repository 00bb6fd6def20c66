#!/usr/bin/env bash
# Builds the page: target/web is a folder for any static host. Needs the target wasm32-unknown-unknown of rustup, nothing else.
set -euo pipefail
cd "$(dirname "$0")/../.."
# SIMD of 128 bits is in every browser since 2023; fronts of an elimination tree go into each other more deeply than 1 MB of stack allows.
export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS="-C target-feature=+simd128 -C link-arg=-zstack-size=8388608"
cargo build --profile browser --target wasm32-unknown-unknown -p ertel-web --lib
target=${CARGO_TARGET_DIR:-target}
rm -rf "$target/web"
mkdir -p "$target/web"
cp crates/ertel-web/page/* THIRD_PARTY_NOTICES.txt LICENSE-APACHE LICENSE-MIT "$target/web/"
cp "$target/wasm32-unknown-unknown/browser/ertel_web.wasm" "$target/web/ertel.wasm"
echo "$target/web: $(wc -c < "$target/web/ertel.wasm") bytes of WebAssembly, $(gzip -9c "$target/web/ertel.wasm" | wc -c) compressed"

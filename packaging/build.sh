#!/usr/bin/env bash
# Builds everything that a release consists of into target/release-files, and tries each: a static program, a Debian package, the
# Python wheel, the documentation as a site, the web page with the solver, and their checksums. Needs Rust, a C compiler with the static C library, Python 3 and, for the
# Debian package, dpkg-deb. Tools of Rust and Python that it needs are installed below target.
set -euo pipefail
cd "$(dirname "$0")/.."
target=$PWD/target
export CARGO_TARGET_DIR=$target
triple=$(rustc -vV | sed -n 's/^host: //p')
version=$(cargo metadata --no-deps --format-version 1 | sed 's/.*"name":"ertel-cli","version":"\([^"]*\)".*/\1/')
out=$target/release-files
parts=$target/release-parts
rm -rf "$out" "$parts"
mkdir -p "$out" "$parts"

# The C library is linked in, so that the program runs on any Linux of this processor.
RUSTFLAGS="-C target-feature=+crt-static" cargo build --release --locked --target "$triple" --bin ertel
program=$target/$triple/release/ertel
if ldd "$program" 2> /dev/null | grep -q '=>'; then
  echo "$program is not static" >&2
  exit 1
fi
strip "$program"
for shell in bash zsh fish; do "$program" completions "$shell" > "$parts/ertel.$shell"; done
"$program" man --output "$parts/man" > /dev/null

# An archive with the program, its manual pages, completions, licences and cases.
name=ertel-$version-$triple
mkdir "$parts/$name"
cp "$program" THIRD_PARTY_NOTICES.txt README.md CHANGELOG.md LICENSE-APACHE LICENSE-MIT CITATION.cff "$parts/$name/"
cp -r cases studies validation benchmark-suite "$parts/man" "$parts/$name/"
mkdir "$parts/$name/completions"
cp "$parts"/ertel.{bash,zsh,fish} "$parts/$name/completions/"
tar -C "$parts" --sort=name --owner=0 --group=0 --numeric-owner -czf "$out/$name.tar.gz" "$name"
"$parts/$name/ertel" solve cases/ball-on-disc.toml --quiet --output "$parts/ball-on-disc"
test -s "$parts/ball-on-disc/result.json"

# The Debian package holds the same program.
if command -v dpkg-deb > /dev/null; then
  test -x "$target/tools/bin/cargo-deb" || cargo install --quiet --locked --root "$target/tools" --target-dir "$target/tools/target" "cargo-deb@^3"
  PATH=$target/tools/bin:$PATH cargo deb --quiet --no-build --target "$triple" --package ertel-cli --output "$out/"
  dpkg-deb --extract "$out"/ertel_*.deb "$parts/deb"
  "$parts/deb/usr/bin/ertel" --version
fi

python3 -m venv "$parts/venv"
"$parts/venv/bin/python" -m pip install --quiet "maturin>=1.9,<2"
"$parts/venv/bin/maturin" build --quiet --release --locked --manifest-path crates/ertel-py/Cargo.toml --out "$out"
python3 -m venv "$parts/fresh"
"$parts/fresh/bin/python" -m pip install --quiet "$out"/ertel-*.whl
"$parts/fresh/bin/python" -c 'import ertel; print(ertel.Case.from_file("cases/ball-on-disc.toml").solve().film_central)'

# The documentation as a site.
packaging/book.sh "$parts/ertel-$version-documentation"
cp THIRD_PARTY_NOTICES.txt LICENSE-APACHE LICENSE-MIT "$parts/ertel-$version-documentation/"
tar -C "$parts" --sort=name --owner=0 --group=0 --numeric-owner -czf "$out/ertel-$version-documentation.tar.gz" "ertel-$version-documentation"

crates/ertel-web/build.sh
tar -C "$target" --sort=name --owner=0 --group=0 --numeric-owner -czf "$out/ertel-$version-web.tar.gz" web

(cd "$out" && sha256sum -- * > SHA256SUMS && ls -l)

#!/usr/bin/env bash
# Installs each file of target/release-files into an empty place and uses it there. Run it after packaging/build.sh; it needs that script's
# folder, Python 3 with venv, for the page node and Chromium, and for the empty roots the right to change the root (root, or namespaces of users).
# Where that is not allowed, programs run without an environment instead of in an empty root, as the output states.
set -euo pipefail
cd "$(dirname "$0")/.."
files=$PWD/target/release-files
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT

# Without an environment there is no path to it.
chroot=$(command -v chroot || true)
unshare=$(command -v unshare || true)
if [ -n "$chroot" ] && unshare --map-root-user true 2> /dev/null; then
  within() { local root=$1; shift; env -i "$unshare" --map-root-user "$chroot" "$root" "$@"; }
  roots="an empty root"
elif [ -n "$chroot" ] && chroot / true 2> /dev/null; then
  within() { local root=$1; shift; env -i "$chroot" "$root" "$@"; }
  roots="an empty root"
else
  within() { local root=$1 program=$2; shift 2; (cd "$root" && env -i "./$program" "${@/#\//./}"); }
  roots="no environment (a new root is not allowed here)"
fi

# solved ROOT PROGRAM: solves a case in a root that contains only the program and this case.
solved() {
  cp cases/roller.toml "$1/case.toml"
  within "$1" "$2" solve /case.toml --quiet --output /result
  test -s "$1/result/result.json"
  test -s "$1/result/report.html"
}

# The archive: only its program is used.
root=$place/static
mkdir "$root" "$place/archive"
tar -C "$place/archive" --strip-components=1 -xzf "$files"/ertel-*-linux-*.tar.gz
cp "$place/archive/ertel" "$root/ertel"
solved "$root" /ertel
for file in THIRD_PARTY_NOTICES.txt LICENSE-MIT LICENSE-APACHE man/ertel.1 man/ertel-solve.1 completions/ertel.bash completions/ertel.zsh completions/ertel.fish; do
  test -s "$place/archive/$file"
done
bash -n "$place/archive/completions/ertel.bash"
echo "archive: solves in $roots"

# The Debian package, extracted by dpkg-deb into a root without its dependencies.
if command -v dpkg-deb > /dev/null && ls "$files"/ertel_*.deb > /dev/null 2>&1; then
  root=$place/deb
  dpkg-deb --extract "$files"/ertel_*.deb "$root"
  solved "$root" /usr/bin/ertel
  for file in man/man1/ertel.1.gz man/man1/ertel-solve.1.gz bash-completion/completions/ertel zsh/vendor-completions/_ertel \
    fish/vendor_completions.d/ertel.fish doc/ertel/THIRD_PARTY_NOTICES.txt doc/ertel/copyright; do
    test -s "$root/usr/share/$file"
  done
  echo "Debian package: solves in $roots"
fi

# The wheel: nothing is built; only numpy is installed, from a local folder.
python3 -m venv "$place/venv"
python=$place/venv/bin/python
"$python" -m pip download --quiet --only-binary :all: --dest "$place/wheels" "numpy>=1.24"
clean=(env -i HOME="$place" PATH=/usr/bin:/bin)
if "${clean[@]}" sh -c 'command -v cargo || command -v rustc'; then
  echo "Rust is in /usr/bin: the wheel is not tried without it" >&2
fi
"${clean[@]}" "$python" -m pip install --quiet --no-index --find-links "$place/wheels" "$files"/ertel-*.whl
"${clean[@]}" "$python" -c 'import sys, ertel
result = ertel.Case.from_file(sys.argv[1]).solve()
assert 535e-9 < float(result.film_central) < 537e-9, result.film_central
from importlib.metadata import files
assert any(file.name == "THIRD_PARTY_NOTICES.txt" for file in files("ertel"))' "$PWD/cases/roller.toml"
echo "wheel: solves without Rust and without an index"

# The documentation and the page.
mkdir "$place/book" "$place/web"
tar -C "$place/book" --strip-components=1 -xzf "$files"/ertel-*-documentation.tar.gz
test -s "$place/book/index.html" -a -s "$place/book/THIRD_PARTY_NOTICES.txt"
echo "documentation: $(find "$place/book" -name '*.html' | wc -l) pages"
tar -C "$place/web" --strip-components=1 -xzf "$files"/ertel-*-web.tar.gz
test -s "$place/web/README.txt" -a -s "$place/web/THIRD_PARTY_NOTICES.txt"
if command -v node > /dev/null && command -v "${CHROMIUM:-chromium}" > /dev/null; then
  ERTEL=$place/archive/ertel ERTEL_WEB=$place/web node crates/ertel-web/tests/browser.mjs
else
  echo "no node or no Chromium: the page was not opened"
fi

#!/usr/bin/env bash
# Checks a release tag: v and the version of the workspace; the first section of CHANGELOG.md must have this version with its date.
#
#     packaging/check-tag.sh v0.1.0
set -euo pipefail
cd "$(dirname "$0")/.."
tag=${1:?the tag of the release, such as v0.1.0}
version=$(sed -n '/^\[workspace.package\]/,/^\[/s/^version = "\(.*\)"/\1/p' Cargo.toml)
if [ "$tag" != "v$version" ]; then
  echo "error: the tag is $tag, and the version in Cargo.toml $version" >&2
  exit 1
fi
heading=$(grep -m 1 '^## ' CHANGELOG.md)
date=${heading#"## $version, "}
if ! [[ $date =~ ^[0-9]{4}-[0-9]{2}-[0-9]{2}$ ]]; then
  echo "error: CHANGELOG.md begins with \"$heading\" and not with \"## $version, YEAR-MONTH-DAY\"" >&2
  exit 1
fi
echo "$tag: CHANGELOG.md has its date, $date"

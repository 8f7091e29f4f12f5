#!/usr/bin/env bash
# A ParaView to build plugins against, beside an installed VTK.
#
#   bash pipelines/paraview/overlay.sh [PREFIX]      default PREFIX: build/paraview-prefix
#
# Debian's python3-paraview, which find_package(ParaView), pvpython and pvbatch need, conflicts with python3-vtk9,
# which libvtk9-dev needs. So it is unpacked below PREFIX, beside links to the files of the installed packages
# paraview and paraview-dev. CMake files are copied: they look for their neighbours where they really are.
# Does nothing when PREFIX is already there for the installed version.
set -euo pipefail
prefix="${1:-$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)/build/paraview-prefix}"

version="$(dpkg-query -W -f='${Version}' paraview)"
if [ "$(cat "$prefix/version" 2>/dev/null)" = "$version" ]; then exit 0; fi

echo "Making $prefix from Debian's ParaView $version" >&2
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
(cd "$work" && apt-get download -qq -o APT::Sandbox::User=root "python3-paraview=$version" >/dev/null)
rm -rf "$prefix"
mkdir -p "$prefix"
prefix="$(cd "$prefix" && pwd)"
dpkg -x "$work"/python3-paraview_*.deb "$prefix"

dpkg -L paraview paraview-dev | sort -u >"$work/listed"
while read -r file; do
  if [ -e "$file" ] && { [ ! -d "$file" ] || [ -L "$file" ]; }; then printf '%s\n' "$file"; fi
done <"$work/listed" >"$work/files"
grep '/cmake/paraview-' "$work/files" | xargs -d '\n' cp -L --parents -t "$prefix"
grep -v '/cmake/paraview-' "$work/files" | xargs -d '\n' cp -s --parents -f -t "$prefix"
printf '%s\n' "$version" >"$prefix/version"

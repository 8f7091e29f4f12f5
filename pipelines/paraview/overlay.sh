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
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
prefix="${1:-$here/../../build/paraview-prefix}"

version="$(dpkg-query -W -f='${Version}' paraview)"
stamp="$prefix/version"
if [ -f "$stamp" ] && [ "$(cat "$stamp")" = "$version" ] && [ -x "$prefix/usr/bin/pvpython" ]; then exit 0; fi

echo "Making $prefix from Debian's ParaView $version" >&2
unpacked="$(mktemp -d)"
trap 'rm -rf "$unpacked"' EXIT
chmod 755 "$unpacked" # apt downloads as a user of its own
(cd "$unpacked" && apt-get download -qq "python3-paraview=$version" >/dev/null)
rm -rf "$prefix"
mkdir -p "$prefix"
dpkg -x "$unpacked"/python3-paraview_*.deb "$prefix"

dpkg -L paraview paraview-dev | sort -u | while read -r file; do
  if [ -d "$file" ] && [ ! -L "$file" ]; then continue; fi
  [ -e "$file" ] || continue
  mkdir -p "$prefix$(dirname "$file")"
  case "$file" in
    */cmake/paraview-*) cp -L "$file" "$prefix$file" ;;
    *) ln -sfn "$file" "$prefix$file" ;;
  esac
done
printf '%s\n' "$version" >"$stamp"

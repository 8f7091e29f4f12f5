#!/usr/bin/env bash
# Installs the Debian package into a Debian that has nothing else, and runs it there: the command, the Python package, and
# a project that finds Core with nothing but a compiler, CMake and Eigen.
#
#   bash testing/package/clean_root.sh AUTHALIC.deb [FOLDER]
#
# FOLDER (a temporary one by default) takes about 2.5 GB while it runs. Needs root, debootstrap and a Debian mirror
# (AUTHALIC_MIRROR, http://deb.debian.org/debian); takes several minutes. Leaves with 77 and a reason where it cannot run.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
deb="$(realpath "${1:?usage: clean_root.sh AUTHALIC.deb [FOLDER]}")"
mirror="${AUTHALIC_MIRROR:-http://deb.debian.org/debian}"

skip() { echo "skipped: $1"; exit 77; }
command -v debootstrap >/dev/null || skip "debootstrap is not installed"
[ "$(id -u)" -eq 0 ] || skip "changing the root directory needs root"

root="$(realpath -m "${2:-$(mktemp -d /tmp/authalic-root.XXXXXX)}")"
finish() {
  mountpoint -q "$root/proc" && umount "$root/proc"
  rm -rf --one-file-system "$root"
}
trap finish EXIT

inside() { LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive chroot "$root" "$@"; }

debootstrap --variant=minbase bookworm "$root" "$mirror" >"$root.log" 2>&1 || { tail -20 "$root.log"; exit 1; }
rm -f "$root.log"
mount -t proc proc "$root/proc"
printf '#!/bin/sh\nexit 101\n' >"$root/usr/sbin/policy-rc.d" # no daemons
chmod +x "$root/usr/sbin/policy-rc.d"
cp "$deb" "$root/tmp/authalic.deb"
cp "$here"/../../data/{torus,bumpy_disk}.off "$here/use_in_clean_root.py" "$root/tmp/"
cp -r "$here/core" "$root/tmp/core"

inside apt-get update -qq
inside apt-get install -y -qq -o Dpkg::Use-Pty=0 --no-install-recommends /tmp/authalic.deb >/dev/null
echo "installed: $(inside dpkg-query -W -f='${Package} ${Version}' authalic), $(inside dpkg-query -W | wc -l) packages in all"

inside authalic --version
inside authalic info /tmp/torus.off | grep -q "genus" || { echo "authalic info says nothing of the genus"; exit 1; }
inside authalic map authalic /tmp/bumpy_disk.off -o /tmp/map.vtp --report /tmp/map.json
inside /usr/bin/python3 /tmp/use_in_clean_root.py

inside apt-get install -y -qq -o Dpkg::Use-Pty=0 --no-install-recommends g++ cmake make libeigen3-dev >/dev/null
inside cmake -S /tmp/core -B /tmp/core/build >/dev/null
inside cmake --build /tmp/core/build >/dev/null
inside /tmp/core/build/flatten
echo "The package installs in a clean root and runs."

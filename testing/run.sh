#!/usr/bin/env bash
# Sets up, builds and runs every test, the fast main job, the sanitizer build and the ParaView plugin included; ends with ctest's summary.
#
#   bash testing/run.sh [ctest options, e.g. -LE slow]
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
. "$here/../pipelines/setup.sh"

authalic_install
authalic_build release
authalic_build sanitize
if authalic_install_paraview; then authalic_build paraview; fi
authalic_display
cd "$authalic_root"
ctest --preset release --no-tests=error "$@"

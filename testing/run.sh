#!/usr/bin/env bash
# Sets up, builds and runs every test, the fast main job and the sanitizer build included; ends with ctest's summary.
#
#   bash testing/run.sh [ctest options, e.g. -LE slow]
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
. "$here/../pipelines/setup.sh"

authalic_install
authalic_build release
authalic_build sanitize
authalic_display
cd "$authalic_root"
ctest --preset release --no-tests=error "$@"

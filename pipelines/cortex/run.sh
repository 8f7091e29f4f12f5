#!/usr/bin/env bash
# From a T1 MRI to area-preserving flat maps of both hemispheres with per-element statistics, in one command.
#
#   bash pipelines/cortex/run.sh [--fast] [--t1 FILE [--labels FILE]] [--surface FILE] [--out DIR] [...]
#
# Installs what is missing (apt), builds, and runs pipelines/cortex/cortex.py, to which all options go.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
. "$here/../setup.sh"

authalic_install
authalic_build release
authalic_display
site="$(echo "$authalic_root"/build/release/lib/python3*/dist-packages)"
PYTHONPATH="$site${PYTHONPATH:+:$PYTHONPATH}" /usr/bin/python3 "$here/cortex.py" "$@"

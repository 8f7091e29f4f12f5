#!/usr/bin/env bash
# A cortex flattened in ParaView without a window: pictures, the flat map, and a state file to open in the GUI.
#
#   bash pipelines/paraview/run.sh [--surface FILE [--cortex FILE]] [--faces N] [--out DIR]
#
# Installs what is missing (apt), builds the plugin, and runs pipelines/paraview/flatten.py in pvbatch, to which all
# options go. Ends with the command that opens the result.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
. "$here/../setup.sh"

authalic_install
authalic_install_paraview
authalic_build paraview
authalic_display
plugin="$(echo "$authalic_root"/build/paraview/lib/paraview-*/plugins/Authalic/Authalic.so)"
"$authalic_root/build/paraview-prefix/usr/bin/pvbatch" "$here/flatten.py" --plugin "$plugin" "$@"

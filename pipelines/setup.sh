#!/usr/bin/env bash
# Sourced by pipelines/*/run.sh and testing/run.sh: installs what is missing (apt), configures and builds.
#
#   authalic_install           apt packages; quick and silent when all are there
#   authalic_install_paraview  ParaView's packages, and build/paraview-prefix to build against; 1 when it cannot be had
#   authalic_build PRESET      cmake --preset PRESET, then build
#   authalic_display           starts one virtual X server unless DISPLAY is set (VTK 9.1 needs one to render)

authalic_root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"

# Needed to build and to run the main job.
authalic_required=(
  g++ cmake ninja-build
  libvtk9-dev libeigen3-dev libcgal-dev libsuitesparse-dev libopenblas-dev
  libnifti2-dev libexpat1-dev zlib1g-dev libcli11-dev nlohmann-json3-dev libgtest-dev
  python3 python3-numpy xvfb xauth fonts-dejavu-core mricron-data
)
# Independent readers and oracles: tests that need a missing one skip and say so.
authalic_optional=(python3-scipy python3-nibabel connectome-workbench gifti-bin nifti-bin clang libbenchmark-dev mypy doxygen dpkg-dev)
# For the ParaView plugin, installed by the scripts that use it.
authalic_paraview=(paraview paraview-dev libopenmpi-dev openmpi-bin libutfcpp-dev libdouble-conversion-dev libpython3-dev)

authalic_missing() {
  local package
  for package in "$@"; do
    [ "$(dpkg-query -W -f='${db:Status-Abbrev}' "$package" 2>/dev/null)" = "ii " ] || printf '%s\n' "$package"
  done
}

authalic_apt() {
  local sudo=()
  if [ "$(id -u)" -ne 0 ]; then sudo=(sudo); fi
  DEBIAN_FRONTEND=noninteractive "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get "$@"
}

# Installs those of the packages that are missing, as far as apt can.
authalic_try() {
  local missing package
  mapfile -t missing < <(authalic_missing "$@")
  [ "${#missing[@]}" -gt 0 ] || return 0
  echo "Installing ${#missing[@]} Debian packages: ${missing[*]}" >&2
  authalic_apt update -qq >&2 || echo "apt-get update failed; going on with the package lists that are there." >&2
  authalic_apt install -y -qq --no-install-recommends "${missing[@]}" >/dev/null 2>&1 ||
    for package in "${missing[@]}"; do # one by one, to name the one that fails
      authalic_apt install -y -qq --no-install-recommends "$package" >/dev/null 2>&1 || true
    done
}

authalic_install() {
  local missing
  authalic_try "${authalic_required[@]}" "${authalic_optional[@]}"
  mapfile -t missing < <(authalic_missing "${authalic_optional[@]}")
  [ "${#missing[@]}" -eq 0 ] || echo "Could not install ${missing[*]}: tests that need them will skip." >&2
  mapfile -t missing < <(authalic_missing "${authalic_required[@]}")
  if [ "${#missing[@]}" -gt 0 ]; then
    echo "Could not install ${missing[*]}, which the build needs; check apt's sources and try again." >&2
    return 1
  fi
}

authalic_install_paraview() {
  local missing note="$authalic_root/build/paraview-unavailable"
  authalic_try "${authalic_paraview[@]}"
  mapfile -t missing < <(authalic_missing "${authalic_paraview[@]}")
  mkdir -p "$authalic_root/build"
  rm -f "$note"
  if [ "${#missing[@]}" -gt 0 ]; then
    echo "ParaView cannot be installed here: apt does not give ${missing[*]}." | tee "$note" >&2
    return 1
  fi
  local overlay="$authalic_root/pipelines/paraview/overlay.sh"
  if ! bash "$overlay" && ! { authalic_apt update -qq >&2 && bash "$overlay"; }; then
    echo "ParaView cannot be installed here: python3-paraview could not be downloaded and unpacked." | tee "$note" >&2
    return 1
  fi
}

authalic_build() {
  local preset="$1"
  (
    cd "$authalic_root" || exit 1
    if [ ! -f "build/$preset/build.ninja" ]; then
      echo "Configuring build/$preset" >&2
      cmake --preset "$preset" >"/tmp/authalic-configure.$$" 2>&1 || { cat "/tmp/authalic-configure.$$" >&2; exit 1; }
      rm -f "/tmp/authalic-configure.$$"
    fi
    cmake --build --preset "$preset" >&2
  )
}

authalic_display() {
  [ -z "${DISPLAY:-}" ] || return 0
  local number
  exec {authalic_display_fd}< <(exec Xvfb -displayfd 1 -screen 0 1920x1200x24 -nolisten tcp -noreset 2>/dev/null)
  authalic_xvfb=$!
  trap 'kill "$authalic_xvfb" 2>/dev/null' EXIT
  if read -r -t 20 -u "$authalic_display_fd" number; then
    export DISPLAY=":$number"
  else
    echo "No virtual display could be started: pictures will be skipped." >&2
  fi
}

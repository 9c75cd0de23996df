# SPDX-License-Identifier: BSD-3-Clause
# Sourced by Testing/run and examples/run: set-up and building on Debian or Ubuntu, from nothing.

say() { printf '\n== %s\n' "$*"; }

# What every configuration and its tests need, and, below, what ParaView's CMake files ask for:
# the -dev packages of libraries that its VTK links to, which paraview-dev does not depend on.
illumination_packages=(
  g++ cmake ninja-build ccache dpkg-dev file
  libembree-dev libglm-dev libtbb-dev
  libgtest-dev libboost-dev
  paraview-dev python3-paraview python3-dev python3-numpy python3-matplotlib
  libopenmpi-dev openmpi-bin libdouble-conversion-dev libexpat1-dev libfreetype-dev liblz4-dev liblzma-dev
  libutfcpp-dev
  qttools5-dev qtxmlpatterns5-dev-tools # help pages in ParaView
  xvfb xauth libgl1-mesa-dri            # pictures without a screen
)
# Without these the build or a test just leaves something out (the format check, benchmarks, the fuzz tests).
illumination_optional_packages=(clang-format-14 libbenchmark-dev librapidcheck-dev)

is_installed() { [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

# For the plugin's part of ParaView's window (units, handles, icons): those of the Qt that ParaView uses.
qt_packages() {
  if apt-cache show paraview 2>/dev/null | grep -q libqt6core; then
    echo qt6-base-dev libqt6svg6
  else
    echo qtbase5-dev libqt5svg5
  fi
}

# What is not installed; of the optional ones, what apt-get has.
missing_packages() {
  local name
  for name in "${illumination_packages[@]}"; do
    is_installed "$name" || echo "$name"
  done
  for name in "${illumination_optional_packages[@]}" $(qt_packages); do
    is_installed "$name" || ! apt-cache show "$name" >/dev/null 2>&1 || echo "$name"
  done
}

# Installs what is missing; where there is no apt-get it trusts that everything is there.
install_packages() {
  command -v apt-get >/dev/null || { say "No apt-get here: taking the installed packages as they are"; return; }
  [ -n "$(missing_packages)" ] || return 0
  local root=() log
  [ "$(id -u)" = 0 ] || root=(sudo)
  log=$(mktemp)
  "${root[@]}" apt-get update -q
  local missing
  mapfile -t missing < <(missing_packages)
  say "Installing ${missing[*]}"
  "${root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "${missing[@]}" >"$log" 2>&1 ||
    { cat "$log"; return 1; }
  rm -f "$log"
}

# The configurations compile the same sources with the same flags, but for warnings as errors, so most of it is done once.
use_compiler_cache() {
  command -v ccache >/dev/null || return 0
  export CCACHE_DIR=${CCACHE_DIR:-$PWD/build/ccache} CCACHE_BASEDIR=${CCACHE_BASEDIR:-$PWD} CCACHE_NOHASHDIR=1
  export CCACHE_IGNOREOPTIONS=-Werror
  export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
}

# build PRESET [TARGET...]: configures build/PRESET the first time (ninja sees to later changes)
# and builds everything or the targets.
build() {
  local preset=$1
  shift
  use_compiler_cache
  if [ ! -f "build/$preset/build.ninja" ]; then
    say "Configuring build/$preset"
    cmake --preset "$preset"
  fi
  say "Building build/$preset"
  cmake --build --preset "$preset" -j "$(nproc)" ${*:+--target "$@"}
}

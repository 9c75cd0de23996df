# SPDX-License-Identifier: BSD-3-Clause
# Sourced by Testing/run and examples/run: set-up and building on Debian or Ubuntu, from nothing.

say() { printf '\n== %s\n' "$*"; }

# What every configuration and its tests need, and, below, what ParaView's CMake files ask for:
# the -dev packages of libraries that its VTK links to, which paraview-dev does not depend on.
illumination_packages=(
  g++ cmake ninja-build
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

# Installs what is missing; where there is no apt-get it trusts that everything is there.
install_packages() {
  command -v apt-get >/dev/null || { say "No apt-get here: taking the installed packages as they are"; return; }
  local missing=() name
  for name in "${illumination_packages[@]}"; do
    is_installed "$name" || missing+=("$name")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  say "Installing ${missing[*]}"
  local root=() log
  [ "$(id -u)" = 0 ] || root=(sudo)
  log=$(mktemp)
  "${root[@]}" apt-get update -q
  for name in "${illumination_optional_packages[@]}"; do
    is_installed "$name" || ! apt-cache show "$name" >/dev/null 2>&1 || missing+=("$name")
  done
  "${root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "${missing[@]}" >"$log" 2>&1 ||
    { cat "$log"; return 1; }
  rm -f "$log"
}

# build PRESET [TARGET...]: configures build/PRESET the first time (ninja sees to later changes)
# and builds everything or the targets.
build() {
  local preset=$1
  shift
  if [ ! -f "build/$preset/build.ninja" ]; then
    say "Configuring build/$preset"
    cmake --preset "$preset"
  fi
  say "Building build/$preset"
  cmake --build --preset "$preset" -j "$(nproc)" ${*:+--target "$@"}
}

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# instructions.sh EFFECT_COSTS: how many instructions a photon takes, scene by scene, through the
#   scene's own walk and through the one with every effect; EFFECT_COSTS is the built benchmark.
# instructions.sh COMMIT: the same for the diffuse room, now and at that commit.
# Counted by valgrind on one thread: the difference between BLOCKS blocks of 256 photons and none.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
blocks=${BLOCKS:-400}
what=${1:?EFFECT_COSTS or COMMIT}

collected() {
  valgrind --tool=callgrind --callgrind-out-file=/dev/null "$@" 2>&1 | sed -n 's/.*Collected : //p'
}

# per_photon COMMAND ARGUMENT... [-- ARGUMENT...]: BLOCKS goes where the two dashes are.
per_photon() {
  local all none
  all=$(collected "${@/#--/$blocks}")
  none=$(collected "${@/#--/0}")
  awk "BEGIN { printf \"%.1f\", ($all - $none) / ($blocks * 256) }"
}

more() {
  awk -v now="$1" -v before="$2" 'BEGIN {
    more = 100 * (now / before - 1)
    printf "%+.1f", (more > -0.05 && more < 0.05 ? 0 : more)
  }'
}

scenes() {
  local diffuse own general scene
  echo "| scene | instructions a photon | more than diffuse, % | every effect compiled in | more, % |"
  echo "|---|---|---|---|---|"
  diffuse=$(per_photon "$what" count diffuse --)
  for scene in "diffuse" "table of grey materials" "one coloured triangle" "one mirror triangle" \
    "one pane triangle" "direct light only" "10 point lamps" "photometric lamp" "open room" \
    "open room, even sky" "open room, CIE clear sky"; do
    own=$(per_photon "$what" count "$scene" --)
    general=$(per_photon "$what" count "$scene" -- general)
    echo "| $scene | $own | $(more "$own" "$diffuse") | $general | $(more "$general" "$own") |"
  done
}

# build FOLDER PROGRAM: the diffuse room with the core in that folder.
build() {
  local embree=4
  [ -e /usr/include/embree4 ] || embree=3
  "${CXX:-c++}" -O3 -DNDEBUG -std=c++17 -ffp-contract=off -fvisibility=hidden \
    "-DILLUMINATION_EMBREE_VERSION=$embree" "-I$1/filters" "-I$1/Testing/Shapes" \
    "$root/Testing/Benchmarks/DiffuseRoom.cxx" "$1/Testing/Shapes/Shapes.cxx" \
    $(find "$1/filters/PhotonTransport" -name '*.cxx' ! -path '*/filtration/*') \
    "-lembree$embree" -ltbb -o "$2"
}

commits() {
  local reflectance before now
  folder=$(mktemp -d)
  trap 'rm -rf "$folder"' EXIT
  mkdir "$folder/before"
  git -C "$root" archive "$what" filters Testing/Shapes | tar -x -C "$folder/before"
  build "$folder/before" "$folder/room_before"
  build "$root" "$folder/room_now"
  echo "| diffuse room | at $what | now | more, % |"
  echo "|---|---|---|---|"
  for reflectance in 0.5 0; do
    before=$(per_photon "$folder/room_before" "$reflectance" --)
    now=$(per_photon "$folder/room_now" "$reflectance" --)
    echo "| reflectance $reflectance | $before | $now | $(more "$now" "$before") |"
  done
}

if [ -x "$what" ]; then scenes; else commits; fi

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# examples/run_examples.sh [FILE [options]]: runs the examples, or lights FILE, with the plugin that
# ILLUMINATION_PLUGIN names. Called by examples/run, which builds it; --help lists the options.
set -euo pipefail
examples=$(cd "$(dirname "$0")" && pwd)
output=$examples/output
: "${ILLUMINATION_PLUGIN:?the path of IlluminationMaps.so; examples/run sets it}"
mkdir -p "$output"

# ParaView of Debian 12 cannot read most .vtp files: see the source of this small library.
if [ "$examples/common/expat_reparse.c" -nt "$output/expat_reparse.so" ]; then
  "${CC:-cc}" -shared -fPIC -O2 -o "$output/expat_reparse.so" "$examples/common/expat_reparse.c" -ldl
fi

# Without -noreset the X server starts over whenever its last window closes.
draw() {
  xvfb-run -a -s "-noreset -screen 0 1280x1024x24 -nolisten tcp" \
    env LD_PRELOAD="$output/expat_reparse.so" PYTHONDONTWRITEBYTECODE=1 pvbatch "$@"
}

if [ $# -gt 0 ]; then
  draw "$examples/your_mesh/your_mesh.py" "$@"
  exit
fi
draw "$examples/cylinder_and_sphere/cylinder_and_sphere.py" "$output"
draw "$examples/curved_surface/curved_surface.py" "$output"
draw "$examples/reflecting_disk/reflecting_disk.py" "$output"
draw "$examples/cabin/cabin.py" "$output"
draw "$examples/cabin/cabin_methods.py" "$output"
draw "$examples/cabin_appearance/cabin_appearance.py" "$output"
draw "$examples/filtration/filtration.py" "$output"
draw "$examples/glass_sphere/glass_sphere.py" "$output"
draw "$examples/cabin_materials/cabin_materials.py" "$output"
draw "$examples/daylight_room/daylight_room.py" "$output"
draw "$examples/adaptive_refinement/adaptive_refinement.py" "$output"
draw "$examples/work_plane/work_plane.py" "$output"
draw "$examples/photon_map/photon_map.py" "$output"
draw "$examples/accuracy_and_time/accuracy_and_time.py" "$output" --quick
PYTHONDONTWRITEBYTECODE=1 python3 "$examples/ranks/ranks.py" "$output" # which starts pvbatch by mpiexec
printf '\nPictures and tables are in %s\n' "$output"

# SPDX-License-Identifier: BSD-3-Clause
"""What accuracy costs in time: true and estimated error against photons and seconds.

Run by pvpython: accuracy_and_time.py OUTPUT_DIR [--quick] [--check | --redraw]. Writes there the
points of all curves as CSV, a figure for each scene, all figures in one, and a table. --check
measures only what is promised and fails where it does not hold; --redraw draws the figures anew.
"""

import argparse
import csv
import os
import sys
from dataclasses import replace
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "common")]

import tables  # noqa: E402
from charts import draw, stack  # noqa: E402
from checks import run_checks  # noqa: E402
from illumination import REGISTRATIONS, load_plugin  # noqa: E402
from runs import Run, curve, long_run, photon_numbers  # noqa: E402
from scenes import SCENES  # noqa: E402

LONG_RUN = 100  # times the photons of the longest curve
TARGETS = (0.05, 0.02, 0.01)
MOST_PHOTONS = 2_000_000_000
STEEP = ("sphere",)  # scenes where Sobol's error falls as 1 / photons


def machine():
    """Processor and number of cores."""
    lines = Path("/proc/cpuinfo").read_text().splitlines()
    models = {line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")}
    return f"{', '.join(sorted(models))}, {os.cpu_count()} cores"


def curves(scene, truth):
    """Rows of all curves of a scene."""
    rows = []
    for registration in REGISTRATIONS:
        for sampling in ("Random", "Sobol"):
            for threads in (1, 2):
                points = curve(
                    scene,
                    truth,
                    photon_numbers(scene.largest),
                    Registration=registration,
                    Sampling=sampling,
                    NumberOfThreads=threads,
                )
                head = {"Scene": scene.name, "Registration": registration}
                head.update({"Sampling": sampling, "Threads": threads})
                rows += [{**head, **point} for point in points]
                print(f"{scene.name}: {registration}, {sampling}, {threads} threads", flush=True)
    return rows


def costs(scene, truth, targets):
    """What it takes to reach each relative error with the default settings, as rows of a table."""
    rows = []
    with Run(scene) as run:
        for target in targets:
            run.proxy.TargetRelativeError = target
            lux = run.to(MOST_PHOTONS)
            now = {name: float(values[-1]) for name, values in run.rounds().items()}
            rows.append(
                {
                    "Scene": scene.title,
                    "Asked for": f"{100 * target:g} %",
                    "Seconds": now["Seconds"],
                    "Photons": int(now["Photons"]),
                    "Estimated error, %": 100.0 * now["RelativeError"],
                    "True error, %": 100.0 * scene.relative_error(lux, truth),
                }
            )
    return rows


def write_csv(path, rows):
    """All points of all curves; errors are shares of the mean illuminance."""
    with open(path, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(rows[0])
        writer.writerows([tables.text(v, 6) for v in row.values()] for row in rows)


def make_scenes(quick):
    """All scenes by name; quick ones have shorter curves."""
    scenes = {name: make() for name, make in SCENES.items()}
    if quick:
        scenes = {n: replace(s, largest=s.largest // 20) for n, s in scenes.items()}
    return scenes


def truth_of(scene, output):
    """The exact illuminance, or where it is not known that of a run many times longer."""
    if scene.exact is not None:
        return scene.exact
    return long_run(scene, LONG_RUN * scene.largest, output)


def measure(scenes, output, quick):
    """Measures all scenes; writes the CSV and the table."""
    rows, prices = [], []
    for scene in scenes.values():
        truth = truth_of(scene, output)
        rows += curves(scene, truth)
        prices += costs(scene, truth, TARGETS[:1] if quick else TARGETS)
    write_csv(output / "accuracy_and_time.csv", rows)
    heading = f"What accuracy costs with the default settings ({machine()})"
    tables.write(prices, output / "costs", heading)


def main(output, options):
    """Measures and draws, or checks; returns the exit code."""
    load_plugin()
    output.mkdir(parents=True, exist_ok=True)
    scenes = make_scenes(options.quick)
    if options.check:
        reference = truth_of(scenes["cabin"], output)
        return run_checks(scenes["sphere"], scenes["cabin"], reference)
    if not options.redraw:
        measure(scenes, output, options.quick)
    rows = tables.read(output / "accuracy_and_time.csv")
    for name, scene in scenes.items():
        own = [row for row in rows if row["Scene"] == name]
        draw(output / f"{name}.png", scene, own, machine(), steep=name in STEEP)
    stack([output / f"{name}.png" for name in scenes], output / "accuracy_and_time.png")
    return 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", type=Path, metavar="OUTPUT_DIR")
    parser.add_argument("--quick", action="store_true", help="short runs, rough curves")
    parser.add_argument("--check", action="store_true", help="measure only what is promised")
    parser.add_argument("--redraw", action="store_true", help="figures from an earlier CSV")
    arguments = parser.parse_args()
    sys.exit(main(arguments.output, arguments))

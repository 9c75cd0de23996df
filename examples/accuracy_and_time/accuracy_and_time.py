# SPDX-License-Identifier: BSD-3-Clause
"""What accuracy costs in time: true and estimated error against photons and seconds.

Run by pvpython: accuracy_and_time.py OUTPUT_DIR [--quick] [--check | --part PART | --redraw]. Writes
there the points of all curves as CSV, a figure for each scene, all these in one, a figure of both
methods, and tables. --check measures only what is promised and fails where it does not hold. --part
measures one part alone, of a minute or so, and keeps its rows in OUTPUT_DIR/parts; --redraw makes
figures and tables of all parts that have been measured so. The part long_runs is to be the first.
"""

import argparse
import os
import sys
from functools import cache
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "common")]

import tables  # noqa: E402
from charts import draw, stack  # noqa: E402
from checks import run_checks  # noqa: E402
from illumination import REGISTRATIONS, load_plugin  # noqa: E402
from methods import METHODS, method_curve  # noqa: E402
from methods_chart import best_rows, draw_methods  # noqa: E402
from rooms import FEATURES, METHOD_SCENES  # noqa: E402
from runs import Run, curve, long_run, photon_numbers, truth_of  # noqa: E402
from scenes import SCENES  # noqa: E402

LONG_RUN = 100  # times the photons of the longest curve: Photon Tracing, which --check needs
TARGETS = {"Photon Tracing": (0.05, 0.02, 0.01), "Final Gathering": (0.05, 0.02)}
LONGEST = 8.0  # s: where the curves of the methods end
BUDGETS = (0.1, 0.5, 2.0, 8.0)  # s
QUICKER = {"largest": 20, "long": 10, "longest": 8}  # times shorter with --quick
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


def costs(scene, truth, method, targets):
    """What it takes to reach each relative error with the default settings, as rows of a table."""
    rows = []
    with Run(scene, Method=method) as run:
        for target in targets:
            run.proxy.TargetRelativeError = target
            lux = run.to(MOST_PHOTONS)
            now = {name: float(values[-1]) for name, values in run.rounds().items()}
            rows.append(
                {
                    "Scene": scene.title,
                    "Method": method,
                    "Asked for": f"{100 * target:g} %",
                    "Seconds": now["Seconds"],
                    "Photons": int(now["Photons"]),
                    "Estimated error, %": 100.0 * now["RelativeError"],
                    "True error, %": 100.0 * scene.relative_error(lux, truth),
                }
            )
    return rows


@cache
def scene_of(name, quick):
    """A scene, made once; a quick one has a shorter curve and long run."""
    scene = {**SCENES, **METHOD_SCENES}[name]()
    if quick:
        scene.largest //= QUICKER["largest"]
        scene.long //= QUICKER["long"]
    return scene


def longest_run(quick):
    """Seconds after which the curves of the methods end."""
    return LONGEST / QUICKER["longest"] if quick else LONGEST


def long_runs(output, quick):
    """The error of what each scene is compared with; makes the long runs, which are kept as files."""
    return [
        {"Scene": name, "Truth's error": truth_of(scene_of(name, quick), output).error}
        for name in {**METHOD_SCENES, **SCENES}
    ]


def parts_of(output, quick):
    """Names of all parts of the measurement, each with what returns its rows; long_runs comes first."""
    longest = longest_run(quick)

    def part(rows_of, name, *rest):
        def measure():
            scene = scene_of(name, quick)
            return rows_of(scene, truth_of(scene, output), *rest)

        return measure

    def word(method):
        return method.lower().replace(" ", "_")

    parts = {"long_runs": lambda: long_runs(output, quick)}
    for name in METHOD_SCENES:
        for method in METHODS:
            parts[f"methods_{name}_{word(method)}"] = part(method_curve, name, method, longest)
    for name in SCENES:
        parts[f"curves_{name}"] = part(curves, name)
    if not quick:
        for method, targets in TARGETS.items():
            for name in SCENES:
                parts[f"costs_{name}_{word(method)}"] = part(costs, name, method, targets)
    return parts


def file_of(output, part):
    """Where a part's rows are kept."""
    return output / "parts" / f"{part}.csv"


def kept_rows(output, parts, start):
    """The rows of all parts whose names start so; none as long as one of these is to be measured."""
    files = [file_of(output, part) for part in parts if part.startswith(start)]
    if not all(file.exists() for file in files):
        print(f"Not all parts {start}... are measured, so they are not drawn", flush=True)
        return []
    return [row for file in files for row in tables.read(file)]


def draw_which_method(output, rows, quick):
    """The figure and the table of both methods."""
    tables.write_csv(rows, output / "which_method_curves.csv")
    draw_methods(output / "which_method.png", FEATURES, rows, machine())
    budgets = [seconds for seconds in BUDGETS if seconds <= longest_run(quick)]
    heading = f"Error at the points within so many seconds ({machine()})"
    tables.write(best_rows(FEATURES, rows, budgets), output / "which_method", heading)


def draw_curves(output, rows, quick):
    """The figures of registrations, samplings and threads."""
    tables.write_csv(rows, output / "accuracy_and_time.csv")
    for name in SCENES:
        own = [row for row in rows if row["Scene"] == name]
        draw(output / f"{name}.png", scene_of(name, quick), own, machine(), steep=name in STEEP)
    stack([output / f"{name}.png" for name in SCENES], output / "accuracy_and_time.png")


def draw_costs(output, rows, _):
    """The table of what accuracy costs."""
    heading = f"What accuracy costs with the default settings ({machine()})"
    tables.write(rows, output / "costs", heading)


def draw_all(output, parts, quick):
    """Figures and tables of the parts' rows."""
    kinds = {"methods_": draw_which_method, "curves_": draw_curves, "costs_": draw_costs}
    for start, draw_rows in kinds.items():
        rows = kept_rows(output, parts, start)
        if rows:
            draw_rows(output, rows, quick)


def check(output, quick):
    """Measures what is promised; returns the exit code."""
    scenes = {name: scene_of(name, quick) for name in SCENES}
    cabin = scenes["cabin"]
    traced = long_run(cabin, LONG_RUN * cabin.largest, output, "Photon Tracing")
    return run_checks(scenes, traced, truth_of(cabin, output))


def main(output, options):
    """Measures and draws, or checks; returns the exit code."""
    load_plugin()
    output.mkdir(parents=True, exist_ok=True)
    if options.check:
        return check(output, options.quick)
    parts = parts_of(output, options.quick)
    if options.part and options.part not in parts:
        print("There is no such part. These are:", *parts, sep="\n")
        return 2
    for part in [options.part] if options.part else [] if options.redraw else parts:
        tables.write_csv(parts[part](), file_of(output, part))
    if not options.part:
        draw_all(output, parts, options.quick)
    return 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", type=Path, metavar="OUTPUT_DIR")
    parser.add_argument("--quick", action="store_true", help="short runs, rough curves")
    parser.add_argument("--check", action="store_true", help="measure only what is promised")
    parser.add_argument("--part", help="measure one part of all alone; an unknown one: their names")
    parser.add_argument("--redraw", action="store_true", help="figures and tables of measured parts")
    arguments = parser.parse_args()
    sys.exit(main(arguments.output, arguments))

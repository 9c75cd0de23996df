# SPDX-License-Identifier: BSD-3-Clause
"""What each effect costs a scene that calls for it, and what leaving it out does to the result.

Run by pvbatch: effects_cost.py OUTPUT_DIR [--quick | --redraw]; takes minutes. Writes there the
table (CSV and Markdown) and a figure. --redraw draws the figure anew from an earlier table.
"""

import argparse
import sys
from pathlib import Path

import numpy as np
from paraview import servermanager, simple
from vtk.util.numpy_support import vtk_to_numpy

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "common")]

import tables  # noqa: E402
from accuracy import accuracy, point_areas  # noqa: E402
from chart import change_text, draw  # noqa: E402
from furnished_room import SWITCHES, Pipeline, rooms  # noqa: E402
from illumination import IlluminationMap, facts_of, load_plugin  # noqa: E402

TARGET = 0.02
MOST_PHOTONS = 2_000_000_000  # the target comes first
NONE = "nothing"


def run(pipeline, **properties):
    """The illumination map."""
    proxy = pipeline.map(**properties)
    proxy.UpdatePipeline()
    result = servermanager.Fetch(proxy)
    simple.Delete(proxy)
    if result.GetPointData().GetArray("Illuminance") is None:
        raise RuntimeError("IlluminationMap has failed; its message is above")
    return IlluminationMap(result, facts_of(result))


def pairs(pipeline, switch, repetitions):
    """Maps with the error asked for, whole and without an effect: each first every other time."""
    maps = {NONE: [], "without": []}
    for seed in range(repetitions + 1):  # the first to warm up
        both = [(NONE, {}), ("without", switch)]
        for name, properties in both if seed % 2 == 0 else reversed(both):
            settings = {"Photons": MOST_PHOTONS, "TargetRelativeError": TARGET, "Seed": seed}
            maps[name].append(run(pipeline, **settings, **properties))
    return maps[NONE][1:], maps["without"][1:]


def change_of(whole, without):
    """RMS change of the illuminance and its standard error, % of the mean; noise taken out."""
    areas = point_areas(whole[0].surface)
    before, after = (np.array([m.array() for m in maps]) for maps in (whole, without))
    mean = before.mean(axis=0)
    result = accuracy(after - before + mean, mean, areas)
    to_percent = 100.0 * mean.max() / np.average(mean, weights=areas)
    return to_percent * result.rms, to_percent * result.rms_error


def facts(maps, name):
    """One fact of all maps."""
    return np.array([m.facts[name] for m in maps])


def with_spread(row, heading, values):
    """Adds the median and the quartiles."""
    names = (heading, heading + " low", heading + " high")
    row.update(zip(names, np.quantile(values, [0.5, 0.25, 0.75]).tolist()))


def row_of(title, name, whole, without):
    """What is told about a scene without an effect; both are maps, pair by pair."""
    row = {"Scene": title, "Without": name}
    rates = facts(without, "SegmentsPerSecond") * 1e-6
    seconds = facts(without, "Seconds")
    quotients = rates / facts(whole, "SegmentsPerSecond") * 1e6
    with_spread(row, "Million segments/s", rates)
    with_spread(row, "Rate gained, %", 100.0 * (quotients - 1.0))
    with_spread(row, "Seconds to 2 %", seconds)
    with_spread(row, "Time saved, %", 100.0 * (1.0 - seconds / facts(whole, "Seconds")))
    row["Flux switched off, lm"] = facts(without, "FluxSwitchedOff")[-1]
    row["Change, %"], row["Its standard error"] = change_of(whole, without)
    return row


def measure(room, repetitions):
    """Rows of a scene: with all it calls for, then without one effect after the other."""
    rows, all_whole = [], []
    with Pipeline(room) as pipeline:
        for effect in room.effects:
            whole, without = pairs(pipeline, SWITCHES[effect], repetitions)
            rows.append(row_of(room.title, effect, whole, without))
            all_whole += whole
    return [row_of(room.title, NONE, all_whole, all_whole), *rows]


def with_quartiles(row, heading):
    """"5.2 (4.8 … 6.0)" """
    middle, low, high = (tables.text(row[heading + end], 2) for end in ("", " low", " high"))
    return f"{middle} ({low} … {high})"


def short(row):
    """A row for the reader."""
    whole = row["Without"] == NONE
    change, error = row["Change, %"], row["Its standard error"]
    return {
        "Scene": row["Scene"] if whole else "",
        "Without": row["Without"],
        "Million segments/s": tables.text(row["Million segments/s"]),
        "Rate gained, %": "" if whole else with_quartiles(row, "Rate gained, %"),
        "Seconds to 2 %": with_quartiles(row, "Seconds to 2 %"),
        "Time saved, %": "" if whole else with_quartiles(row, "Time saved, %"),
        "Flux switched off, lm": tables.text(row["Flux switched off, lm"]),
        "RMS change, % of the mean": "" if whole else change_text(change, error),
    }


def main(output, options):
    """Measures and draws."""
    file = output / "effects_cost.csv"
    if not options.redraw:
        load_plugin()
        rows = []
        for room in rooms():
            rows += measure(room, 3 if options.quick else 7)
            print(room.title, flush=True)
        tables.write_csv(rows, file)
    rows = tables.read(file)
    table = tables.markdown([short(row) for row in rows])
    print(table, flush=True)
    (output / "effects_cost.md").write_text(table + "\n")
    draw(output / "effects_cost.png", rows)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", type=Path, metavar="OUTPUT_DIR")
    parser.add_argument("--quick", action="store_true", help="few repetitions")
    parser.add_argument("--redraw", action="store_true", help="figure from an earlier table")
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    main(arguments.output, arguments)

# SPDX-License-Identifier: BSD-3-Clause
"""What each effect costs a scene that calls for it, and what leaving it out does to the result.

Run by pvbatch: effects_cost.py OUTPUT_DIR [--quick | --redraw]. Writes there the table (CSV and
Markdown) and a figure. --redraw draws the figure anew from an earlier table.
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
from chart import draw  # noqa: E402
from furnished_room import Pipeline, rooms  # noqa: E402
from illumination import IlluminationMap, facts_of, load_plugin, texts  # noqa: E402

PHOTONS = 400_000  # of each measurement of a rate
TARGET = 0.02
MOST_PHOTONS = 2_000_000_000
# What the lines of the field array Effects begin with -> the properties that leave the effect out.
SWITCHES = {
    "compensation": {"Registration": "Flat"},
    "interreflection": {"Interreflection": 0},
    "specular reflection": {"SpecularReflection": 0},
    "glossy reflection": {"GlossyReflection": 0},
    "diffuse transmission": {"DiffuseTransmission": 0},
    "clear transmission": {"ClearTransmission": 0},
    "refraction": {"Refraction": 0},
    "colour": {"Colour": 0},
}


def run(pipeline, **properties):
    """The illumination map, and the lines of its array Effects."""
    proxy = pipeline.map(**properties)
    proxy.UpdatePipeline()
    result = servermanager.Fetch(proxy)
    simple.Delete(proxy)
    if result.GetPointData().GetArray("Illuminance") is None:
        raise RuntimeError("IlluminationMap has failed; its message is above")
    return IlluminationMap(result, facts_of(result)), texts(result, "Effects")


def variants(pipeline):
    """What is left out -> properties, first nothing; only what the scene calls for."""
    lines = run(pipeline, Photons=1000)[1]
    called = {line.split(":")[0] for line in lines if ": on" in line}
    found = {name: switch for name, switch in SWITCHES.items() if name in called}
    if pipeline.properties.get("LampContributions"):
        found["lamps kept apart"] = {"LampContributions": 0}
    return {"nothing": {}, **found}


def in_turn(choices, repetitions, measure):
    """name -> what measure(properties, repetition) gave; forwards and backwards in turn."""
    results = {name: [] for name in choices}
    for repetition in range(repetitions):
        order = list(choices.items())
        for name, properties in order if repetition % 2 == 0 else reversed(order):
            results[name].append(measure(properties, repetition))
    return results


def change_of(without, whole):
    """RMS change of the illuminance and its standard error, % of the mean; noise taken out."""
    areas = point_areas(whole[0].surface)
    maps = np.array([m.array() for m in without]) - np.array([m.array() for m in whole])
    mean = np.mean([m.array() for m in whole], axis=0)
    result = accuracy(maps + mean, mean, areas)
    to_percent = 100.0 * mean.max() / np.average(mean, weights=areas)
    return to_percent * result.rms, to_percent * result.rms_error


def spread(values):
    """Median and quartiles."""
    return np.quantile(values, [0.5, 0.25, 0.75])


def row_of(title, name, rates, maps):
    """What is told about a scene without an effect."""
    rate = np.array(rates[name])
    seconds = np.array([m.facts["Seconds"] for m in maps[name]])
    whole = np.array([m.facts["Seconds"] for m in maps["nothing"]])
    flux = maps[name][-1].facts["FluxSwitchedOff"]
    row = {"Scene": title, "Without": name}
    for heading, numbers in (
        ("Million segments/s", rate),
        ("Rate gained, %", 100.0 * (rate / np.array(rates["nothing"]) - 1.0)),
        ("Seconds to 2 %", seconds),
        ("Time saved, %", 100.0 * (1.0 - seconds / whole)),
    ):
        middle, low, high = spread(numbers)
        row.update({heading: middle, heading + " low": low, heading + " high": high})
    row["Flux switched off, lm"] = flux
    row["Change, %"], row["Its standard error"] = change_of(maps[name], maps["nothing"])
    return row


def measure(room, repetitions):
    """Rows of a scene: with all it calls for, then without one effect after the other."""
    with Pipeline(room) as pipeline:
        choices = variants(pipeline)
        rates = in_turn(
            choices,
            repetitions,
            lambda properties, _: run(pipeline, Photons=PHOTONS, **properties)[0].facts[
                "SegmentsPerSecond"
            ]
            * 1e-6,
        )
        goal = {"Photons": MOST_PHOTONS, "TargetRelativeError": TARGET}
        maps = in_turn(
            choices,
            repetitions,
            lambda properties, seed: run(pipeline, Seed=seed + 1, **goal, **properties)[0],
        )
    return [row_of(room.title, name, rates, maps) for name in choices]


def with_quartiles(row, heading):
    """"5.2 (4.8 … 6.0)" """
    middle, low, high = (tables.text(row[heading + end], 2) for end in ("", " low", " high"))
    return f"{middle} ({low} … {high})"


def short(row):
    """A row for the reader."""
    whole = row["Without"] == "nothing"
    change, error = row["Change, %"], row["Its standard error"]
    certain = f"< {tables.text(2.0 * error, 2)}" if change < 2.0 * error else tables.text(change, 2)
    return {
        "Scene": row["Scene"] if whole else "",
        "Without": row["Without"],
        "Million segments/s": tables.text(row["Million segments/s"]),
        "Rate gained, %": "" if whole else with_quartiles(row, "Rate gained, %"),
        "Seconds to 2 %": with_quartiles(row, "Seconds to 2 %"),
        "Time saved, %": "" if whole else with_quartiles(row, "Time saved, %"),
        "Flux switched off, lm": tables.text(row["Flux switched off, lm"]),
        "RMS change, % of the mean": "" if whole else certain,
    }


def main(output, options):
    """Measures and draws."""
    file = output / "effects_cost.csv"
    if not options.redraw:
        load_plugin()
        rows = []
        for room in rooms().values():
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

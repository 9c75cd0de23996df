# SPDX-License-Identifier: BSD-3-Clause
"""Draws what FacetGrowth has written: python3 facet_growth.py TABLE.csv PICTURE.png."""

import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def read_columns(path):
    """Columns of numbers by name."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


def draw(table, path):
    """Three curves against the number of triangles: rate, time to build, memory."""
    triangles = table["triangles"]
    figure, (rate, build, memory) = plt.subplots(1, 3, figsize=(12, 3.6), layout="constrained")
    rate.plot(triangles, table["bare Embree's"], "o--", color="tab:gray", label="bare Embree")
    rate.plot(triangles, table["million segments/s"], "o-", label="photon tracing, all in")
    rate.set_ylabel("million rays or segments a second")
    rate.set_ylim(bottom=0)
    build.plot(triangles, table["Embree's build s"], "o--", color="tab:gray", label="Embree's build")
    build.plot(triangles, table["ready s"], "o-", label="scene ready")
    build.set_ylabel("seconds")
    build.set_yscale("log")
    points = table["points"]
    memory.plot(triangles, [b / p for b, p in zip(table["bytes told"], points)], "o--", color="tab:gray",
                label="told")
    memory.plot(triangles, [b / p for b, p in zip(table["bytes"], points)], "o-", label="taken, 8 replicates")
    memory.set_ylabel("bytes a point")
    memory.set_ylim(bottom=0, top=2 * max(b / p for b, p in zip(table["bytes told"], points)))
    for axes in (rate, build, memory):
        axes.set_xscale("log")
        axes.set_xlabel("triangles")
        axes.legend()
    figure.savefig(path, dpi=110)


if __name__ == "__main__":
    draw(read_columns(sys.argv[1]), sys.argv[2])

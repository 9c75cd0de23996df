# SPDX-License-Identifier: BSD-3-Clause
"""The chart of the distance from the exact surface against the turn of the normal."""

import numpy as np
from matplotlib.ticker import FixedLocator, FuncFormatter, NullFormatter

from convergence import CHART
from pictures import INK, Page

COLOURS = {"Cylinder": "#c05000", "Sphere": "#0060a8", "Torus": "#2a8a3c"}


def draw_convergence(path, rows, finer):
    """Draws the rows of convergence.turns_rows(), of coarse bodies and of finer ones."""
    page = Page(1100, 640)
    page.write(16, 14, CHART, fontsize=15, fontweight="bold")
    axes = page.place(95, 60, 975, 505)
    axes.axis("on")
    turns = np.array([row["MaximumTurn, degrees"] for row in rows])
    first = max(rows[0][f"{name}, %"] for name in COLOURS)
    axes.loglog(turns, 1.6 * first * (turns / turns[0]) ** 2, color="#909090", linewidth=1.2,
                linestyle="--", label="a quarter for each half")  # fmt: skip
    for name, colour in COLOURS.items():
        of_mesh = {"o": (rows, name), "s": (finer, f"{name} with twice the facets along every edge")}
        for marker, (its_rows, label) in of_mesh.items():
            values = [row[f"{name}, %"] for row in its_rows]
            face = colour if marker == "o" else "white"
            axes.loglog(turns, values, color=colour, marker=marker, markersize=6, linewidth=1.6,
                        markerfacecolor=face, label=label)  # fmt: skip
    axes.invert_xaxis()
    axes.xaxis.set_major_locator(FixedLocator(turns))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda turn, _: f"{turn:g}"))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.xaxis.set_minor_locator(FixedLocator([]))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda percent, _: f"{percent:g}"))
    axes.set_xlabel("MaximumTurn, degrees", color=INK, fontsize=13)
    axes.set_ylabel("Mean distance, % of the radius", color=INK, fontsize=13)
    axes.grid(True, color="#e4e4e4", linewidth=0.7)
    axes.tick_params(colors=INK, labelsize=12)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    axes.legend(fontsize=12, frameon=False, loc="lower left")
    page.save(path)

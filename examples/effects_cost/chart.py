# SPDX-License-Identifier: BSD-3-Clause
"""The figure: for each scene and effect the rate, the time, and what leaving it out does."""

import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  (the backend comes first)

INK, FAINT, GRID = "#202020", "#909090", "#e4e4e4"
WHOLE, WITHOUT, CHANGE = "#202020", "#0060a8", "#c05000"
GAP = 0.9  # rows between two scenes


def places(rows):
    """The height of each row, downwards; a scene's first row is the scene as it is."""
    heights, y = [], 0.0
    for row in rows:
        y -= 1.0 + (GAP if row["Without"] == "nothing" else 0.0)
        heights.append(y)
    return heights


def dots(axes, rows, heights, heading):
    """A dot for each row with its quartiles, and a line down from the whole scene's."""
    for row, y in zip(rows, heights):
        whole = row["Without"] == "nothing"
        value = row[heading]
        if whole:
            last = max(i for i, other in enumerate(rows) if other["Scene"] == row["Scene"])
            axes.plot([value] * 2, [y, heights[last] - 0.3], color=GRID, linewidth=1.4, zorder=0)
            reference = value
        else:
            axes.plot([reference, value], [y, y], color="#a8c8e0", linewidth=1.6, zorder=1)
        colour = WHOLE if whole else WITHOUT
        axes.plot([row[heading + " low"], row[heading + " high"]], [y, y], color=colour, linewidth=3.2, alpha=0.35, solid_capstyle="butt", zorder=2)
        axes.plot(value, y, "o", color=colour, markersize=5.5, zorder=3)
    axes.set_xlim(left=0.0)


def bars(axes, rows, heights):
    """How far the illuminance changes, with the flux that was switched off."""
    for row, y in zip(rows, heights):
        if row["Without"] == "nothing":
            continue
        change, error = row["Change, %"], row["Its standard error"]
        sure = change >= 2.0 * error
        axes.barh(y, change if sure else 0.0, 0.55, color=CHANGE)
        text = f"{change:.2g} %" if sure else f"< {2.0 * error:.1g} %"
        flux = row["Flux switched off, lm"]
        text += f"   ({flux:.0f} lm not followed)" if flux >= 0.5 else ""
        axes.annotate(text, (change if sure else 0.0, y), xytext=(5, 0), textcoords="offset points", va="center", fontsize=9, color=INK)
    axes.set_xlim(0.0, 1.0 * max(row["Change, %"] for row in rows))


def frame(axes, title):
    """Grid and ticks of one panel."""
    axes.set_title(title, loc="left", fontsize=11, color=INK, pad=8)
    axes.grid(True, axis="x", color=GRID, linewidth=0.7)
    axes.set_axisbelow(True)
    axes.tick_params(axis="y", length=0)
    axes.tick_params(axis="x", colors=INK, labelsize=9.5)
    for side in ("top", "right", "left"):
        axes.spines[side].set_visible(False)


def label_rows(axes, rows, heights):
    """Scene and effect beside each row."""
    axes.set_yticks(heights)
    names = ["" if row["Without"] == "nothing" else "without " + row["Without"] for row in rows]
    axes.set_yticklabels(names, fontsize=9.5, color=INK)
    for row, y in zip(rows, heights):
        if row["Without"] == "nothing":
            axes.annotate(
                row["Scene"], (0.0, y), xycoords=("axes fraction", "data"), xytext=(-6, 0),
                textcoords="offset points", ha="right", va="center", fontsize=10.5,
                fontweight="bold", color=INK, annotation_clip=False,
            )  # fmt: skip


def draw(path, rows):
    """Three panels that share their rows."""
    heights = places(rows)
    size = (14.5, 1.4 + 0.245 * -heights[-1])
    figure, panels = pyplot.subplots(1, 3, figsize=size, dpi=100, sharey=True)
    top = 1.0 - 0.75 / size[1]
    figure.subplots_adjust(left=0.2, right=0.985, top=top, bottom=0.45 / size[1], wspace=0.08)
    dots(panels[0], rows, heights, "Million segments/s")
    dots(panels[1], rows, heights, "Seconds to 2 %")
    bars(panels[2], rows, heights)
    frame(panels[0], "Million photon segments a second")
    frame(panels[1], "Seconds to a relative error of 2 %")
    frame(panels[2], "Change of the illuminance by leaving it out, % of the mean (RMS)")
    label_rows(panels[0], rows, heights)
    panels[0].set_ylim(heights[-1] - 0.8, heights[0] + 0.8)
    key = "black: all that the scene calls for;  blue: without one effect;  bands: quartiles"
    figure.text(0.2, 1.0 - 0.28 / size[1], key, fontsize=9.5, color=FAINT)
    figure.savefig(path)
    pyplot.close(figure)
    print(f"Picture: {path}", flush=True)

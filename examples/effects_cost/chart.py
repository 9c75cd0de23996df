# SPDX-License-Identifier: BSD-3-Clause
"""The figure: for each scene and effect the rate, the time, and what leaving it out does."""

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  (the backend comes first)

INK, FAINT, GRID = "#202020", "#909090", "#e4e4e4"
WITHOUT, BAND, PALE, CHANGE = "#0060a8", "#a8c8e8", "#b8d0e4", "#c05000"
LEAST = 1e-6  # %: less is rounding
GAP = 0.9  # rows between two scenes


def places(rows):
    """The height of each row, downwards; a scene's first row is the scene as it is."""
    heights, y = [], 0.0
    for row in rows:
        y -= 1.0 + (GAP if row["Without"] == "nothing" else 0.0)
        heights.append(y)
    return heights


def change_text(change, error):
    """The change in percent, or what it is below where it is within twice its standard error."""
    if change < LEAST:
        return "0"
    return f"< {2.0 * error:.1g}" if change < 2.0 * error else f"{change:.2g}"


def gains(axes, rows, heights, heading, absolute, form):
    """A dot for each effect with its quartiles, and in a scene's first row what it takes."""
    axes.axvline(0.0, color=FAINT, linewidth=0.9, zorder=1)
    for row, y in zip(rows, heights):
        if row["Without"] == "nothing":
            paper = {"facecolor": "white", "edgecolor": "none", "pad": 1.0}
            style = {"fontsize": 9.5, "color": INK, "va": "center", "bbox": paper}
            axes.annotate(form.format(row[absolute]), (0.0, y), xytext=(6, 0),
                          textcoords="offset points", **style)  # fmt: skip
            continue
        ends = [row[heading + " low"], row[heading + " high"]]
        axes.plot([0.0, row[heading]], [y, y], color=PALE, linewidth=1.4, zorder=2)
        axes.plot(ends, [y, y], color=BAND, linewidth=6.0, solid_capstyle="butt", zorder=3)
        axes.plot(row[heading], y, "o", color=WITHOUT, markersize=5.5, zorder=4)


def bars(axes, rows, heights):
    """How far the illuminance changes, with the flux that was switched off."""
    for row, y in zip(rows, heights):
        if row["Without"] == "nothing":
            continue
        change, error = row["Change, %"], row["Its standard error"]
        length = change if change >= max(2.0 * error, LEAST) else 0.0
        axes.barh(y, length, 0.5, color=CHANGE)
        flux = row["Flux switched off, lm"]
        text = change_text(change, error)
        text += f"   ({flux:.0f} lm not followed)" if flux >= 0.5 else ""
        axes.annotate(text, (length, y), xytext=(5, 0), textcoords="offset points",
                      va="center", fontsize=9, color=INK)  # fmt: skip
    longest = max(row["Change, %"] for row in rows)
    axes.set_xlim(0.0, 1.75 * longest)  # room for the text
    axes.set_xticks([tick for tick in axes.get_xticks() if tick <= 1.05 * longest])


def frame(axes, title, grid=True):
    """Grid and ticks of one panel."""
    axes.set_title(title, loc="left", fontsize=11, color=INK, pad=8)
    if grid:
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
    size = (14.5, 1.7 + 0.25 * -heights[-1])
    figure, panels = pyplot.subplots(1, 3, figsize=size, dpi=100, sharey=True)
    top = 1.0 - 0.9 / size[1]
    figure.subplots_adjust(left=0.2, right=0.985, top=top, bottom=0.45 / size[1], wspace=0.08)
    gains(panels[0], rows, heights, "Rate gained, %", "Million segments/s", "{:.2f} million/s")
    gains(panels[1], rows, heights, "Time saved, %", "Seconds to 2 %", "{:.2f} s")
    bars(panels[2], rows, heights)
    frame(panels[0], "Photon segments a second: gain, %")
    frame(panels[1], "Time to a relative error of 2 %: saved, %")
    frame(panels[2], "Illuminance: RMS change, % of the mean", grid=False)
    label_rows(panels[0], rows, heights)
    panels[0].set_ylim(heights[-1] - 0.8, heights[0] + 0.8)
    heading = "What it gains, and what it changes, to leave out an effect that a scene calls for"
    figure.text(0.012, 1.0 - 0.32 / size[1], heading, fontsize=14, fontweight="bold", color=INK)
    key = "dots: medians of pairs; bands: quartiles"
    figure.text(0.985, 1.0 - 0.3 / size[1], key, fontsize=10, color=FAINT, ha="right")
    figure.savefig(path)
    pyplot.close(figure)
    print(f"Picture: {path}", flush=True)

# SPDX-License-Identifier: BSD-3-Clause
"""The figure of both methods: one panel a scene, error at points against seconds."""

import numpy as np
from charts import FAINT, INK, column, draw_curve, draw_estimates, finish, label_ends, select
from matplotlib import pyplot
from matplotlib.lines import Line2D

COLOURS = {"Photon Tracing": "#c05000", "Final Gathering": "#0060a8"}
LINES = {"no": "-", "yes": (0, (4, 2))}
MARGIN = 1.4  # of the axes' range, as a factor
NAMES = {"no": "", "yes": ", smoothed"}


def resolved(rows):
    """The rows whose true error is at least half the error of what they are compared with."""
    return [row for row in rows if row["True error"] > 0.5 * row["Truth's error"]]


def panel(axes, title, rows):
    """The curves of one scene; returns their ends for labels."""
    ends = []
    for method, colour in COLOURS.items():
        for smoothed, style in LINES.items():
            own = resolved(select(rows, Method=method, Smoothed=smoothed))
            if not own:
                continue
            end = draw_curve(axes, own, "Seconds", colour, style)
            ends.append((*end, method + NAMES[smoothed], colour))
            if smoothed == "no":
                draw_estimates(axes, own, "Seconds", colour)
    errors = column(resolved(rows), "True error")
    axes.set_ylim(errors.min() / MARGIN, errors.max() * MARGIN)  # circles may be far above
    own_error = 100.0 * float(rows[0]["Truth's error"])
    truth = f"a long run, {own_error:.2g} % off" if own_error else "exact"
    finish(axes, "Seconds, all included", f"{title}; truth: {truth}")
    return ends


def key(figure):
    """What lines and circles mean."""
    style = {"color": INK, "linewidth": 1.6, "marker": "o", "markersize": 3.2}
    entries = [
        Line2D([], [], **style, label="true error"),
        Line2D([], [], linestyle=LINES["yes"], **style, label="true error of the smoothed map"),
        Line2D([], [], marker="o", markersize=7, mfc="none", mec=INK, linestyle="",
               label="error that the filter itself tells (noise; for Photon Tracing, FacetError too)"),
    ]  # fmt: skip
    figure.legend(
        handles=entries, loc="upper left", bbox_to_anchor=(0.048, 0.972), ncols=3, frameon=False,
        handlelength=3.0,
    )  # fmt: skip


def draw_methods(path, titles, rows, machine):
    """Draws rows (those of method_curves) of scenes (name -> title), two panels a line."""
    lines = (len(titles) + 1) // 2
    figure, panels = pyplot.subplots(lines, 2, figsize=(14.5, 0.7 + 4.6 * lines), dpi=100)
    figure.subplots_adjust(left=0.055, right=0.845, top=0.905, bottom=0.06, wspace=0.58, hspace=0.28)
    heading = "Which method: error at the points against seconds"
    figure.text(0.055, 0.975, heading, fontsize=14, fontweight="bold", color=INK)
    figure.text(0.985, 0.975, machine, fontsize=10, color=FAINT, ha="right")
    key(figure)
    ends = []
    for axes, (name, title) in zip(np.ravel(panels), titles.items()):
        ends.append((axes, panel(axes, title, select(rows, Scene=name))))
    for row in np.atleast_2d(panels):
        row[0].set_ylabel("Error, % of the mean illuminance (RMS over the area)", fontsize=10)
    figure.canvas.draw()
    for axes, own in ends:
        label_ends(axes, own)
    figure.savefig(path)
    pyplot.close(figure)
    print(f"Picture: {path}", flush=True)


def best_rows(titles, rows, budgets):
    """The error of each curve's longest run within a budget of seconds, as rows of a table."""
    table = []
    for name, title in titles.items():
        for budget in budgets:
            row = {"Scene": title, "Seconds": budget}
            for method in COLOURS:
                for smoothed, words in NAMES.items():
                    own = select(rows, Scene=name, Method=method, Smoothed=smoothed)
                    within = column(own, "Seconds") <= budget
                    errors = column(own, "True error")[within]
                    row[f"{method}{words}, %"] = float(errors[-1]) if len(errors) else "–"
            table.append(row)
    return table

# SPDX-License-Identifier: BSD-3-Clause
"""The chart of accuracy against time, and figures as parts of a page."""

import base64
import io

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator

# Columns of the table Accuracy -> what they are called.
ERRORS = {
    "RelativeError": "all of the surface, by area",
    "MedianRelativeError": "half of the points are below",
    "Percentile95RelativeError": "95 % of the points are below",
}


def draw_accuracy(rounds):
    """A figure of relative errors (%) against seconds. rounds: column -> values, as in Accuracy."""
    figure = Figure(figsize=(8.0, 3.8), dpi=130)
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    for column, label in ERRORS.items():
        percent = [100.0 * error for error in rounds[column]]
        axes.plot(rounds["Seconds"], percent, "o-", markersize=4, label=label)
    axes.set_xscale("log")
    axes.set_yscale("log")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_formatter("{x:g}")
        axis.set_minor_formatter("{x:g}")
        axis.set_minor_locator(LogLocator(subs=(2.0, 5.0)))
    axes.set_xlabel("Time, s")
    axes.set_ylabel("Standard error, % of the illuminance")
    axes.grid(True, which="both", color="#e0e0e0", linewidth=0.6)
    axes.legend(fontsize=8)
    figure.tight_layout()
    return figure


def data_uri(png):
    """A picture's bytes as the address of an image within a page."""
    return "data:image/png;base64," + base64.b64encode(png).decode("ascii")


def figure_uri(figure):
    """A figure as the address of an image within a page."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png")
    return data_uri(buffer.getvalue())

# SPDX-License-Identifier: BSD-3-Clause
"""One figure a scene: error against photons and against seconds, both axes logarithmic."""

import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  (the backend comes first)
from matplotlib.lines import Line2D  # noqa: E402
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter  # noqa: E402
from PIL import Image  # noqa: E402

COLOURS = {"Flat": "#c05000", "Facet Ratio": "#8050a0", "Vertex Normalised": "#0060a8"}
PALE = {"Flat": "#e8a878", "Facet Ratio": "#c8a8d8", "Vertex Normalised": "#78b0e0"}
INK, FAINT = "#202020", "#909090"
LINES = {"Sobol": "-", "Random": (0, (4, 2))}
STEP = 0.043  # least distance of labels, as a share of the axes' height


def column(rows, name):
    """One column of some rows; errors in percent."""
    values = np.array([row[name] for row in rows], dtype=float)
    return 100.0 * values if name.endswith("error") else values


def select(rows, **wanted):
    """The rows of a curve."""
    return [row for row in rows if all(row[key] == value for key, value in wanted.items())]


def plain(value, _=None):
    """A tick's text without exponent where that is short."""
    if value >= 1e6:
        return f"{value / 1e6:g} M"
    return f"{value / 1e3:g} k" if value >= 1e4 else f"{value:g}"


def spread(heights):
    """Heights (shares of the axes, ascending) moved apart to STEP, as little as is needed."""
    placed = list(heights)
    for _ in range(200):
        for i in range(1, len(placed)):
            lack = STEP - (placed[i] - placed[i - 1])
            if lack > 1e-9:
                placed[i - 1] -= 0.5 * lack
                placed[i] += 0.5 * lack
    return placed


def merged(ends):
    """One label in the place of three where all registrations of a sampling end together."""
    result = []
    for sampling in LINES:
        own = [end for end in ends if end[2].endswith(sampling)]
        heights = [end[1] for end in own]
        if max(heights) < 1.06 * min(heights):
            own = [(*own[-1][:2], f"all three, {sampling}", INK)]
        result += own
    return result


def label_ends(axes, ends):
    """Writes (x, y, text, colour) beside the right edge, one below the other."""
    to_axes = axes.transData + axes.transAxes.inverted()
    ends = sorted(ends, key=lambda end: end[1])
    where = [to_axes.transform(end[:2]) for end in ends]
    for (x, y), height, end in zip(where, spread([y for _, y in where]), ends):
        axes.annotate(
            end[2],
            xy=(x, y),
            xytext=(1.03, height),
            xycoords="axes fraction",
            textcoords="axes fraction",
            verticalalignment="center",
            fontsize=10,
            color=end[3],
            annotation_clip=False,
            arrowprops={"arrowstyle": "-", "color": end[3], "linewidth": 0.5, "shrinkB": 2.0},
        )


def slope(axes, x, y, power):
    """A grey line of that slope in log-log through (x[0], y); steep ones have their text below."""
    below = power < -0.5
    names = {-0.5: "slope −1/2", -1.0: "slope −1"}
    reach = np.array([x[0], x[-1]])
    values = y * (reach / x[0]) ** power
    style = {"color": FAINT, "linewidth": 1.0, "linestyle": ":"}
    axes.plot(reach, values, zorder=0, scaley=False, **style)
    middle = np.sqrt(reach[0] * reach[1])
    corner = "top" if below else "bottom"
    height = y * (middle / x[0]) ** power * (0.92 if below else 1.08)
    side = "right" if below else "left"
    style = {"fontsize": 10, "color": "#707070", "va": corner, "ha": side}
    axes.text(middle, height, names[power], **style)


def draw_slope(axes, rows, across, steep):
    """How random numbers converge, above their curve, and Sobol points at their best, below."""
    x, y = column(rows, across), column(rows, "Estimated error")
    if rows[0]["Sampling"] == "Random":
        slope(axes, x, 1.5 * np.max(y * np.sqrt(x / x[0])), -0.5)
    elif steep:
        slope(axes, x, 0.6 * np.min(y * x / x[0]), -1.0)


def finish(axes, label, title):
    """Axes, grid and ticks of one panel."""
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel(label, color=INK, fontsize=11)
    axes.set_title(title, loc="left", color=INK, fontsize=11)
    axes.grid(True, which="major", color="#e4e4e4", linewidth=0.7)
    axes.set_axisbelow(True)
    for axis, limits in ((axes.xaxis, axes.get_xlim()), (axes.yaxis, axes.get_ylim())):
        dense = limits[1] < 300.0 * limits[0]
        axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0) if dense else (1.0,), numticks=20))
        axis.set_major_formatter(FuncFormatter(plain))
        axis.set_minor_formatter(NullFormatter())
    axes.tick_params(colors=INK, labelsize=10)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def draw_curve(axes, rows, across, colour, style, width=1.6):
    """The true error of one curve as a line with dots."""
    x, y = column(rows, across), column(rows, "True error")
    axes.plot(x, y, color=colour, linestyle=style, linewidth=width, marker="o", markersize=3.2)
    return x[-1], y[-1]


def draw_estimates(axes, rows, across, colour):
    """The estimated error of one curve as open circles."""
    x, y = column(rows, across), column(rows, "Estimated error")
    axes.plot(x, y, linestyle="", marker="o", markersize=7, mfc="none", mec=colour, mew=0.9)


def against_photons(axes, rows, steep):
    """Left panel: three registrations and two samplings; the number of threads is no matter."""
    ends = []
    for sampling, style in LINES.items():
        for registration in COLOURS:
            own = select(rows, Registration=registration, Sampling=sampling, Threads=2)
            colour = (COLOURS if sampling == "Sobol" else PALE)[registration]
            end = draw_curve(axes, own, "Photons", colour, style)
            ends.append((*end, f"{registration}, {sampling}", COLOURS[registration]))
            if registration == "Vertex Normalised":
                draw_estimates(axes, own, "Photons", colour)
                draw_slope(axes, own, "Photons", steep)
    finish(axes, "Photons", "Error against photons")
    return merged(ends)


def against_seconds(axes, rows, steep):
    """Right panel: the default registration on one and two threads; the others on two."""
    ends = []
    best = "Vertex Normalised"
    for sampling, style in LINES.items():
        for threads, colours in ((1, PALE), (2, COLOURS)):
            own = select(rows, Registration=best, Sampling=sampling, Threads=threads)
            end = draw_curve(axes, own, "Seconds", colours[best], style)
            text = f"{sampling}, {threads} thread" + ("s" if threads > 1 else "")
            ends.append((*end, text, colours[best]))
            if threads == 2:
                draw_estimates(axes, own, "Seconds", colours[best])
                draw_slope(axes, own, "Seconds", steep)
    for registration in ("Facet Ratio", "Flat"):
        own = select(rows, Registration=registration, Sampling="Sobol", Threads=2)
        end = draw_curve(axes, own, "Seconds", COLOURS[registration], "-", 1.0)
        ends.append((*end, f"{registration}, Sobol, 2 threads", COLOURS[registration]))
    finish(axes, "Seconds", f"Error against time ({best} in blue)")
    return ends


def key(figure):
    """What the lines and dots mean."""
    style = {"color": INK, "linewidth": 1.6}
    entries = [
        Line2D([], [], marker="o", markersize=3.2, **style, label="true error, Sobol"),
        Line2D([], [], marker="o", markersize=3.2, linestyle=LINES["Random"], **style,
               label="true error, Random"),
        Line2D([], [], marker="o", markersize=7, mfc="none", mec=INK, linestyle="",
               label="noise that the filter itself estimates (Vertex Normalised)"),
    ]  # fmt: skip
    figure.legend(
        handles=entries, loc="upper left", bbox_to_anchor=(0.055, 0.945), ncols=3, frameon=False,
        handlelength=3.0,
    )


def draw(path, scene, rows, machine, steep):
    """The figure of one scene; steep: Sobol's error falls as 1 / photons."""
    figure, panels = pyplot.subplots(1, 2, figsize=(14.5, 5.6), dpi=100, sharey=True)
    figure.subplots_adjust(left=0.06, right=0.845, top=0.815, bottom=0.1, wspace=0.56)
    figure.text(0.06, 0.95, scene.title, fontsize=14, fontweight="bold", color=INK)
    figure.text(0.985, 0.955, machine, fontsize=10, color=FAINT, ha="right")
    key(figure)
    ends = [against_photons(panels[0], rows, steep), against_seconds(panels[1], rows, steep)]
    panels[0].set_ylabel("Error, % of the mean illuminance (RMS over the area)", fontsize=11)
    panels[1].tick_params(labelleft=True)
    figure.canvas.draw()
    for axes, own in zip(panels, ends):
        label_ends(axes, own)
    figure.savefig(path)
    pyplot.close(figure)
    print(f"Picture: {path}", flush=True)


def stack(paths, target):
    """All figures in one, of few colours so that it stays small."""
    pictures = [Image.open(path).convert("RGB") for path in paths]
    sheet = Image.new("RGB", (pictures[0].width, sum(p.height for p in pictures)))
    top = 0
    for picture in pictures:
        sheet.paste(picture, (0, top))
        top += picture.height
    sheet.quantize(64, dither=Image.Dither.NONE).save(target, optimize=True)
    print(f"Picture: {target}", flush=True)

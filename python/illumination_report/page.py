# SPDX-License-Identifier: BSD-3-Clause
"""The page of the report: its template, filled in. All text is escaped here."""

from html import escape
from pathlib import Path
from string import Template

TEMPLATE = Path(__file__).with_name("template.html")
NONE = "<p>None.</p>"


def _table(rows, heads=()):
    """A table of rows of text; heads: its first line."""
    head = "".join(f"<th>{escape(text)}</th>" for text in heads)
    body = "".join(
        "<tr>" + "".join(f"<td>{escape(str(cell))}</td>" for cell in row) + "</tr>\n" for row in rows
    )
    return f"<table>\n<tr>{head}</tr>\n{body}</table>" if heads else f"<table>\n{body}</table>"


def _list(lines):
    """A list of lines of text."""
    return "<ul>" + "".join(f"<li>{escape(line)}</li>\n" for line in lines) + "</ul>" if lines else NONE


def _figure(address, caption):
    """A picture with a caption. address: a data URI."""
    text = escape(caption)
    return f'<figure><img src="{address}" alt="{text}"><figcaption>{text}</figcaption></figure>'


def _number(value):
    """Three or four digits, no exponents for everyday numbers."""
    return f"{value:,.0f}" if abs(value) >= 1000.0 else f"{value:.3g}"


def _with_error(value, error):
    """A value with its standard error, which may be None."""
    if error is None:
        return _number(value)
    return f"{_number(value)} ± {_number(error) if error >= 100.0 else f'{error:.2g}'}"


def _statistics(rows):
    """The table of statistics: (name, {what: (number, standard error)})."""
    heads = ["", *rows[0][1]]
    return _table([(name, *(_with_error(*v) for v in values.values())) for name, values in rows], heads)


def _rounds(rounds):
    """The last round in words."""
    if not rounds["Seconds"]:
        return "The run had no round."
    error, seconds = rounds["RelativeError"][-1], rounds["Seconds"][-1]
    return f"After {_number(seconds)} s the standard error over all of the surface is {100.0 * error:.2g} %."


def _facets(error):
    """What the size of triangles does, in words. error: as surfaces.facet_error tells it."""
    if error is None:
        return ""
    return (
        f"A value is a mean over the triangles around its point. That puts it off by an estimated {_number(100.0 * error)} % "
        "of the mean illuminance (FacetError, root mean square), which the standard error does not count; finer "
        "triangles or the method Final Gathering help."
    )


def report_page(**parts):
    """The page as text. parts: as report.write_report names them."""
    pictures = "".join(_figure(address, caption) for caption, address in parts["pictures"].items())
    settings = "".join(f"<h3>{escape(name)}</h3>\n{_table(rows)}" for name, rows in parts["settings"])
    plan = "Illuminance of the level from above, with lines of equal illuminance in lx; × are lamps."
    accuracy = "Standard error of the illuminance against time."
    return Template(TEMPLATE.read_text(encoding="utf-8")).substitute(
        title=escape(parts["title"]),
        date=escape(parts["date"]),
        pictures=pictures or NONE,
        plan=_figure(parts["plan"], plan) if parts["plan"] else "<p>No facet is horizontal and faces up.</p>",
        statistics=_statistics(parts["statistics"]),
        statistics_notes=_list(parts["statistics_notes"]),
        accuracy=_figure(parts["accuracy"], accuracy) if parts["accuracy"] else "",
        last_round=escape(_rounds(parts["rounds"])),
        facets=escape(_facets(parts["facet_error"])),
        run=_table(parts["run"]),
        settings=settings,
        effects=_list(parts["effects"]),
        warnings=_list(parts["warnings"]),
        notes=_list(parts["notes"]),
        versions=_table(parts["versions"]),
    )

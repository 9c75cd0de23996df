# SPDX-License-Identifier: BSD-3-Clause
"""Tables: printed, as CSV and as Markdown."""

import csv


def text(value, digits=3):
    """A cell's text: numbers with so many significant digits, no exponents for everyday ones."""
    if not isinstance(value, float):
        return str(value)
    if value == 0.0 or 1e-4 <= abs(value) < 1e7:
        return f"{float(f'{value:.{digits}g}'):.10f}".rstrip("0").rstrip(".")
    return f"{value:.{digits - 1}e}"


def markdown(rows, padded=True):
    """Rows (dicts of the same keys) as a Markdown table, its columns padded if asked."""
    table = [list(rows[0])] + [[text(v) for v in row.values()] for row in rows]
    widths = [max(len(line[i]) for line in table) if padded else 1 for i in range(len(table[0]))]
    lines = ["| " + " | ".join(c.ljust(w) for c, w in zip(line, widths)) + " |" for line in table]
    lines.insert(1, "|" + "|".join("-" * (w + 2) for w in widths) + "|")
    return "\n".join(lines)


def write_csv(rows, path):
    """Writes rows (dicts of the same keys) as CSV."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(list(rows[0]))
        writer.writerows([text(v, 6) for v in row.values()] for row in rows)


def write(rows, stem, heading):
    """Prints a table and writes it to stem.csv and stem.md (a pathlib.Path without suffix)."""
    table = markdown(rows)
    print(f"\n{heading}\n\n{table}\n", flush=True)
    write_csv(rows, stem.with_suffix(".csv"))
    stem.with_suffix(".md").write_text(f"{heading}\n\n{table}\n")


def read(path):
    """The rows of a CSV file, as dicts of numbers and text."""

    def value(cell):
        try:
            return float(cell)
        except ValueError:
            return cell

    with open(path, newline="") as file:
        return [{key: value(cell) for key, cell in row.items()} for row in csv.DictReader(file)]

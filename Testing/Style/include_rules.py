# SPDX-License-Identifier: BSD-3-Clause
"""include_rules.py SOURCE: whether the files in SOURCE/filters include only what they may.

- No circle of files, a header and its source counted as one.
- A folder includes only folders above it in the table of filters/README.md, which is the one place
  where their order is written. So there is no circle of folders either.
- The core (PhotonTransport) includes no header of VTK, Qt or ParaView, and only one file of it
  includes Embree.

Prints what breaks a rule and exits with 1, or with 2 if it finds nothing to check.
"""
import re
import sys
from pathlib import Path

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"]', re.M)
CORE = "PhotonTransport"
EMBREE_FILE = f"{CORE}/scene/EmbreeVersion.h"


def folder_order(readme):
    """The folders of the table, first to last. A row with a dot is a folder inside the last one
    without a dot, which may use all of those inside it and so comes after them."""
    order, outer = [], ""
    for dot, name in re.findall(r"^\| `(· )?(\w+)/` \|", readme, re.M):
        if dot:
            order.insert(-1, f"{outer}/{name}")
        else:
            outer = name
            order.append(name)
    return order


def read_includes(filters):
    """{file: [what it includes, as a path below filters or as it is written]}"""
    files = [p for p in filters.rglob("*") if p.suffix in (".h", ".cxx")]
    includes = {}
    for file in files:
        found = []
        for name in INCLUDE.findall(file.read_text(encoding="utf-8")):
            places = [filters / name, filters / "Illumination" / name, file.parent / name]
            place = next((p for p in places if p.exists()), None)
            found.append(str(place.relative_to(filters)) if place else name)
        includes[str(file.relative_to(filters))] = found
    return includes


def circles(includes):
    """Lists of units (files without their suffix) that include each other, each list once."""
    unit = lambda name: str(Path(name).with_suffix(""))
    graph = {}
    for file, names in includes.items():
        own = {unit(name) for name in names if name in includes}
        graph.setdefault(unit(file), set()).update(own - {unit(file)})

    def reached(start):
        seen, front = set(), [start]
        while front:
            for other in graph[front.pop()] - seen:
                seen.add(other)
                front.append(other)
        return seen

    reach = {start: reached(start) for start in graph}
    groups = {tuple(sorted(b for b in reach[a] if a in reach[b])) for a in graph if a in reach[a]}
    return sorted(groups)


def against_order(includes, order):
    """Includes of folders that are not above the including one."""
    place = {folder: i for i, folder in enumerate(order)}
    for file, names in sorted(includes.items()):
        folder = str(Path(file).parent)
        if folder not in place:
            yield f"{file}: its folder is not in the table of filters/README.md"
            continue
        for name in names:
            other = str(Path(name).parent)
            if name in includes and other != folder and place.get(other, -1) > place[folder]:
                yield f"{file} includes {name}, but {folder} may not use {other}"


def foreign(includes):
    """Includes by the core of what the core must not know."""
    for file, names in sorted(includes.items()):
        for name in names:
            last = name.split("/")[-1]
            embree = name.startswith("embree") and file != EMBREE_FILE
            if file.startswith(f"{CORE}/") and (re.match("vtk|pq|Q[A-Z]", last) or embree):
                yield f"{file} includes {name}"


def main(source):
    filters = Path(source) / "filters"
    includes = read_includes(filters)
    order = folder_order((filters / "README.md").read_text(encoding="utf-8"))
    if not includes or len(order) < 2:
        print(f"Found no files, or no table of folders, below {filters}.")
        return 2
    breaches = ["circle of files: " + " – ".join(circle) for circle in circles(includes)]
    breaches += list(against_order(includes, order)) + list(foreign(includes))
    breaches += [f"{folder}: in the table, but no folder" for folder in order
                 if not (filters / folder).is_dir()]
    print("\n".join(breaches))
    return 1 if breaches else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))

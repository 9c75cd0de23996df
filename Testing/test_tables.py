# SPDX-License-Identifier: BSD-3-Clause
"""What the tables of Testing/README.md share: results from the tests' XML files, and a place between marks."""

import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

sys.path[:0] = [str(Path(__file__).resolve().parents[1] / "examples" / "common")]

import tables  # noqa: E402


def finished_tests(folder):
    """(suite, test, {property: value}) of every test that has run, from the XML files in a folder."""
    for file in sorted(folder.rglob("*.xml")):
        for test in ElementTree.parse(file).iter("testcase"):
            if test.get("status") == "run" and test.find("skipped") is None:
                properties = {p.get("name"): p.get("value") for p in test.iter("property")}
                yield test.get("classname"), test.get("name"), properties


def put_result(folder, suite, test, protects, measured):
    """Leaves the result of a test that is no GoogleTest where finished_tests finds it."""
    suites = ElementTree.Element("testsuites")
    case = ElementTree.SubElement(suites, "testcase", name=test, classname=suite, status="run")
    properties = ElementTree.SubElement(case, "properties")
    for name, value in (("protects", protects), ("measured", measured)):
        ElementTree.SubElement(properties, "property", name=name, value=value)
    folder.mkdir(parents=True, exist_ok=True)
    ElementTree.ElementTree(suites).write(folder / f"{suite}.{test}.xml")


def put_table(page, name, rows):
    """Puts rows (dicts of the same keys) between the marks of a table in a page, if they are new."""
    begin, end = f"<!-- {name} from here -->", "<!-- to here -->"
    text = page.read_text()
    before, rest = text.split(begin)
    after = rest.split(end, 1)[1]
    table = tables.markdown(rows, padded=False)
    new = f"{before}{begin}\n\n{table}\n\n{end}{after}"
    if new != text:
        page.write_text(new)
        print(f"{page} has new results")

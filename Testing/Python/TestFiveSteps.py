# SPDX-License-Identifier: BSD-3-Clause
"""The README's five steps from an OBJ room and an IES file to a table, taken from its text and run."""
import math
import os
import re
import shutil
import tempfile
from pathlib import Path

from paraview import servermanager, simple

ROOT = Path(__file__).resolve().parents[2]
ROOM = """g floor
v 0 0 0
v 6 0 0
v 6 4 0
v 0 4 0
f 1 2 3 4
g ceiling
v 0 0 2.8
v 0 4 2.8
v 6 4 2.8
v 6 0 2.8
f 5 6 7 8
g walls
f 1 5 8 2
f 2 8 7 3
f 3 7 6 4
f 4 6 5 1
"""
CANDELA = 2 * 0.95 * 1000.0  # of lambertian.ies, straight down: two lamps, ballast factor
LIT, MAINTENANCE, ABOVE = [(x, y) for x in (1.5, 4.5) for y in (1.0, 3.0)], 0.8, 2.05
BRIGHTEST = 0.7  # reflectance


def steps():
    """The first block of code in the section on sensors that imports ParaView, with this plugin."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    section = text[text.index("## Work planes, glare and daylight factors") :]
    code = re.search(r"```python\n(from paraview.*?)```", section, re.DOTALL).group(1)
    load = 'LoadDistributedPlugin("IlluminationMaps", ns=globals())'
    assert code.count(load) == 1
    return code.replace(load, 'LoadPlugin(os.environ["ILLUMINATION_PLUGIN"], ns=globals())')


def direct(x, y):
    """Illuminance (lx) of a point on the work plane by the panels alone, as points: I0 cos² / d²."""
    squares = [ABOVE**2 + (x - a) ** 2 + (y - b) ** 2 for a, b in LIT]
    return sum(MAINTENANCE * CANDELA * ABOVE**2 / square**2 for square in squares)


def check():
    found = {"os": os}
    exec(steps(), found)  # pylint: disable=exec-used
    row, plane = found["row"], servermanager.Fetch(found["plane"])
    columns = ("Mean", "MeanError", "Minimum", "U0", "ShareAtTarget", "Area")
    values = {name: row.GetValueByName(0, name).ToDouble() for name in columns}
    assert values["ShareAtTarget"] == 1.0, values
    places = [plane.GetPoint(i) for i in range(plane.GetNumberOfPoints())]
    by_lamps = sum(direct(x, y) for x, y, _ in places) / len(places)
    # Reflected light adds something, and less than the brightest surface alone would all around.
    assert by_lamps < values["Mean"] < by_lamps / (1.0 - BRIGHTEST), (by_lamps, values)
    assert 0.0 < values["MeanError"] < 0.01 * values["Mean"], values
    assert math.isclose(values["U0"], values["Minimum"] / values["Mean"], rel_tol=1e-9), values
    assert math.isclose(values["Area"], 5.0 * 3.0, rel_tol=1e-9), values
    assert all(math.isclose(z, 0.75) for _, _, z in places), places[0]
    eyes = servermanager.Fetch(found["eyes"]).GetPointData().GetArray("UGR")
    assert 10.0 < max(eyes.GetRange(view)[1] for view in range(4)) < 30.0


with tempfile.TemporaryDirectory() as folder:
    Path(folder, "room.obj").write_text(ROOM, encoding="ascii")
    shutil.copy(ROOT / "Testing" / "Data" / "photometry" / "lambertian.ies", Path(folder, "panel.ies"))
    os.chdir(folder)
    check()
    os.chdir(ROOT)
    simple.Disconnect()

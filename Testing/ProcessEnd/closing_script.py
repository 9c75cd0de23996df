# SPDX-License-Identifier: BSD-3-Clause
"""For ParaView's --script: makes a map and closes the window. An error leaves it open, which the test takes for a hang."""
import ctypes
import os

from paraview import simple

simple.LoadPlugin(os.environ["ILLUMINATION_PLUGIN"], remote=False, ns=globals())
lit = IlluminationMap(Input=simple.Sphere(), Photons=20000)  # noqa: F821
lit.UpdatePipeline()
assert lit.PointData["Illuminance"].GetRange()[1] > 0.0
for name in ("libQt5Widgets.so.5", "libQt6Widgets.so.6"):
    try:
        qt = ctypes.CDLL(name, mode=os.RTLD_NOLOAD | os.RTLD_NOW)  # the one that ParaView has loaded
    except OSError:
        continue
    qt._ZN12QApplication15closeAllWindowsEv()

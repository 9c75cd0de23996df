# SPDX-License-Identifier: BSD-3-Clause
"""The cabin's hull is closed: no photon of 20 million segments gets out. Run by pvbatch."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "common")]

from cabin_geometry import make_cabin  # noqa: E402
from illumination import illuminate, load_plugin  # noqa: E402

load_plugin()
facts = illuminate(
    make_cabin(), LampType="Emitting Facets", ExitanceArray="Exitance", Reflectance=0.95, Photons=1_000_000
).facts
assert facts["PhotonsEscaped"] == 0, facts
assert facts["PhotonsCutOff"] == 0, facts
assert facts["PhotonsAbsorbed"] == facts["PhotonsEmitted"], facts
segments = facts["SegmentsPerSecond"] * facts["Seconds"]
# Geometric with mean 20 and variance 380: 4 standard deviations of the mean over a million photons.
assert abs(segments / facts["PhotonsEmitted"] - 20.0) < 4.0 * (380.0 / facts["PhotonsEmitted"]) ** 0.5, segments
print(f"{segments:.0f} segments, none escaped")

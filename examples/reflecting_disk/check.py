# SPDX-License-Identifier: BSD-3-Clause
"""Fails unless the registrations' errors are those of expected.csv. Needs pvbatch, but no screen.

check.py OUTPUT.csv writes what it measures instead, with as many photons as the example.
"""

import sys

from reflecting_disk import HERE, PHOTONS, illumination_maps, measured, scene

from expected import check
from illumination import load_plugin

FEWER_PHOTONS = 3_000_000  # for each seed, enough to tell the registrations apart

if __name__ == "__main__":
    load_plugin()
    black, whole = scene()
    photons = PHOTONS if len(sys.argv) > 1 else FEWER_PHOTONS
    maps = illumination_maps(whole, black.GetNumberOfPoints(), photons)
    check(measured(black, maps)[1], HERE / "expected.csv", factor=2.5)

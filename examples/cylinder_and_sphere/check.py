# SPDX-License-Identifier: BSD-3-Clause
"""Fails unless the registrations' errors are those of expected.csv. Needs pvbatch, but no screen.

check.py OUTPUT.csv writes what it measures instead.
"""

from cylinder_and_sphere import HERE, illumination_maps, measured, scene

from expected import check
from illumination import load_plugin

if __name__ == "__main__":
    load_plugin()
    surface = scene()
    check(measured(surface, illumination_maps(surface)), HERE / "expected.csv", factor=5.0)

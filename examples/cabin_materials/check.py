# SPDX-License-Identifier: BSD-3-Clause
"""The evening's flux, colours, lamps, dimming, gloss and carpet are as they must be, by both methods.

Run by pvbatch.
"""

import sys
from pathlib import Path

import numpy as np
from vtk.util.numpy_support import vtk_to_numpy

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "common"), str(HERE.parent / "cabin")]

from accuracy import point_areas  # noqa: E402
from illumination import load_plugin  # noqa: E402
from lighting import (  # noqa: E402
    COVE_EXITANCE,
    EVENING,
    LAMPS,
    LATE,
    LUMINOUS,
    READING_SEATS,
    contribution,
    differ,
    light,
    reading_light_flux,
)
from scene import PART_NAMES, make_scene, places  # noqa: E402

PHOTONS = 1_000_000
# With 8 replicates a standard error has 7 degrees of freedom: the mean square of a difference over
# its estimate is at most 7 / 5.
RMS_LIMIT = (7.0 / 5.0) ** 0.5
SIGMAS = 3.0  # of errors that are rather too wide, see mean()
GATHERED = {"Method": "Final Gathering", "Photons": 500_000, "GatherRays": 16, "Seed": 5}
FINE = 0.01  # FacetError over illuminance, where facets are fine for the light
FEWEST_POINTS = 50  # of a place whose mean over such points tells something


def mean(found, own, values, error):
    """Mean of point values by area over some points, and its standard error.

    Thrice that of independent points: every photon's hit counts at three of them, and it may hit
    the place again.
    """
    share = point_areas(found.surface)[own]
    share /= share.sum()
    return share @ values[own], 3.0 * np.sqrt(share**2 @ error[own] ** 2)


def differs(first, second):
    """By how many of its standard errors a mean is above another; both with their errors."""
    return (first[0] - second[0]) / np.hypot(first[1], second[1])


def lux(found, place):
    """Mean illuminance of a place (lx) and its standard error."""
    return mean_lux(found, places(found.surface)[place])


def mean_lux(found, own):
    """The same of some points."""
    return mean(found, own, found.array(), found.array("StandardError"))


def red_lux(found, place):
    """The same of the red channel; see smoothed_colours in cabin_materials.py for its error."""
    red = found.array("IlluminanceRGB")[:, 0]
    share = red / np.maximum(LUMINOUS[0] * found.array(), 1e-30)
    own = places(found.surface)[place]
    return mean(found, own, red, found.array("StandardError") * np.sqrt(share))


def check_flux(found):
    """Lamps emit what they should; photons are absorbed or leave by the windows."""
    each = reading_light_flux()
    assert abs(each - 60.0) < 0.05, each  # four digits in the file
    shines = vtk_to_numpy(found.surface.GetCellData().GetArray("Exitance")) > 0.0
    corners = vtk_to_numpy(found.surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    a, b, c = vtk_to_numpy(found.surface.GetPoints().GetData()).astype(float)[corners].transpose(1, 0, 2)
    area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)[shines].sum()
    wanted = COVE_EXITANCE * area + each * len(READING_SEATS)
    facts = found.facts
    assert abs(facts["EmittedFlux"] / wanted - 1.0) < 1e-6, (facts["EmittedFlux"], wanted)
    assert facts["PhotonsCutOff"] == 0 and facts["PhotonsEscaped"] > 0, facts
    assert facts["PhotonsAbsorbed"] + facts["PhotonsEscaped"] == facts["PhotonsEmitted"], facts


def check_sums(found):
    """Colours and lamps each sum up to the illuminance."""
    total = found.array()
    colours = found.array("IlluminanceRGB") @ LUMINOUS
    lamps = sum(found.array(contribution(lamp)) for lamp in LAMPS)
    for name, sums in (("colours", colours), ("lamps", lamps)):
        off = np.abs(sums - total).max() / total.max()
        print(f"sum of {name}: off by {off:.1e} of the brightest point")
        assert off < 1e-5, (name, off)


def check_dimming(found, scene):
    """Maps dimmed without tracing are those of a fresh run; undimmed ones are not."""
    fresh = light(scene, LATE, Photons=PHOTONS, Seed=2)
    right, wrong = differ(found, fresh, LATE), differ(found, fresh, EVENING)
    print(f"dimmed: differs by {right:.3f} standard errors (RMS); undimmed: by {wrong:.1f}")
    assert right < RMS_LIMIT < SIGMAS < wrong, (right, wrong)


def check_gloss(found, scene):
    """The table's gloss lights the bin above it."""
    matt = light(scene, EVENING, Photons=PHOTONS, Seed=3, GlossyReflection=0)
    with_gloss, without = (lux(each, "Bin above it") for each in (found, matt))
    lost = matt.facts["FluxSwitchedOff"]
    print(f"bin above the table: {with_gloss[0]:.2f} lx, without gloss ({lost:.2f} lm) {without[0]:.2f} lx")
    print(f"apart by {differs(with_gloss, without):.1f} standard errors")
    assert differs(with_gloss, without) > SIGMAS, (with_gloss, without)


def check_carpet(found, scene):
    """The red carpet makes the lower side walls redder than a grey one as bright."""
    floor = vtk_to_numpy(scene.GetCellData().GetArray("Part")) == PART_NAMES.index("Floor")
    reflectance = vtk_to_numpy(scene.GetCellData().GetArray("DiffuseReflectance"))
    reflectance[floor] = (reflectance[floor] @ LUMINOUS)[:, None]
    grey = light(scene, EVENING, Photons=PHOTONS, Seed=4)
    red = [red_lux(each, "Lower side walls") for each in (found, grey)]
    print(f"lower side walls: red {red[0][0]:.3f} lx, above a grey carpet {red[1][0]:.3f} lx")
    print(f"apart by {differs(*red):.1f} standard errors")
    assert differs(*red) > SIGMAS, red


def check_methods(found, scene):
    """Final Gathering finds the same light, where facets are fine for it.

    Elsewhere the two are to differ: Photon Tracing has a mean over facets, which FacetError tells.
    """
    gathered = light(scene, EVENING, **GATHERED)
    fine = (found.array("FacetError") < FINE * found.array()) & (found.array() > 0.0)
    square = found.array("FacetError") ** 2
    square = square + sum(one.array("StandardError") ** 2 for one in (found, gathered))
    off = (gathered.array() - found.array())[fine] / np.sqrt(square[fine])
    rms = np.sqrt(np.mean(off**2))
    print(f"Final Gathering at {fine.sum()} points: differs by {rms:.3f} standard errors (RMS)")
    assert rms < RMS_LIMIT, rms
    for place, own in places(found.surface).items():
        if np.count_nonzero(own & fine) >= FEWEST_POINTS:
            traced, by_rays = (mean_lux(one, own & fine) for one in (found, gathered))
            apart = differs(by_rays, traced)
            print(f"{place}: {traced[0]:.3f} lx, gathered {by_rays[0]:.3f}: {apart:.1f} standard errors")
            assert abs(apart) < SIGMAS, (place, traced, by_rays)


def main():
    """Lights the cabin and looks."""
    load_plugin()
    scene = make_scene()
    found = light(scene, EVENING, Photons=PHOTONS)
    check_flux(found)
    check_sums(found)
    check_dimming(found, scene)
    check_gloss(found, scene)
    check_methods(found, scene)
    check_carpet(found, scene)  # changes the scene


if __name__ == "__main__":
    main()

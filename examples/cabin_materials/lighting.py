# SPDX-License-Identifier: BSD-3-Clause
"""The cabin's lamps in the evening, and how they are dimmed with and without tracing. Metres."""

import numpy as np
import vtk
from paraview import servermanager, simple
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from illumination import as_source, illuminate, run_filter
from scene import HERE, TABLE_AHEAD, TABLE_TOP, TABLES, place

COVES = "Coves"
READING_SEATS = ("1E", "1C", "2D", "2F", "3C", "3A")
LAMPS = (COVES, *READING_SEATS)
EVENING = dict.fromkeys(LAMPS, 1.0)  # dimming of every lamp
LATE = {**dict.fromkeys(LAMPS, 0.0), COVES: 0.5, "1E": 0.8}

COVE_EXITANCE = 150.0  # lm/m^2 in the evening; by day, in cabin/, it is 25,000
COVE_COLOUR = np.array([0.14, 0.17, 1.0])  # linear red, green, blue: dusk
LUMINOUS = np.array([0.2126, 0.7152, 0.0722])  # of red, green and blue; ITU-R BT.709
WARM = (1.0, 0.60, 0.27)  # linear red, green, blue of white light of about 2800 K
LAMP_AHEAD, LAMP_HEIGHT = 0.43, 1.57  # of the seat's x = 0; just below the bin
LAMP_ACROSS = {True: 1.13, False: 1.2}  # distance from the aisle's middle: aisle seats, others


def coves(scene, dimming):
    """The scene's surface as a luminaire: it shines where its cell array Exitance says so (lm/m^2)."""
    lit = vtk_to_numpy(scene.GetCellData().GetArray("Exitance"))[:, None]
    exitance = numpy_to_vtk(
        lit * dimming * COVE_EXITANCE * COVE_COLOUR / (LUMINOUS @ COVE_COLOUR), deep=1
    )
    exitance.SetName("Exitance")
    surface = vtk.vtkPolyData()
    surface.ShallowCopy(scene)
    surface.GetCellData().AddArray(exitance)
    return as_source(surface)


def reading_light(seat, dimming):
    """The Luminaire of a seat: it sits in the bin's underside and aims at the table or the lap."""
    x, y = place(seat)
    lamp = np.array([x + LAMP_AHEAD, np.copysign(LAMP_ACROSS[seat[1] in "CD"], y), LAMP_HEIGHT])
    aim = np.array([x + TABLE_AHEAD, y, TABLE_TOP] if seat in TABLES else [x + 0.25, y, 0.6])
    return simple.Luminaire(
        Type="Photometric File",
        LuminaireName=seat,
        FileName=str(HERE / "reading_light.ies"),
        Position=lamp,
        Direction=aim - lamp,
        LightColour=WARM,
        Dimming=dimming,
    )


def reading_light_flux():
    """Luminous flux of a reading light (lm), as the plugin integrates its file."""
    reader = simple.PhotometricReader(FileName=str(HERE / "reading_light.ies"))
    reader.UpdatePipeline()
    flux = servermanager.Fetch(reader).GetFieldData().GetArray("LuminaireFlux").GetTuple1(0)
    simple.Delete(reader)
    return flux


def light(scene, dimming, **properties):
    """The IlluminationMap of the scene; dimming: of every lamp. Lamps at 0 are left out."""
    lamps = [coves(scene, dimming[COVES])]
    lamps += [reading_light(seat, dimming[seat]) for seat in READING_SEATS if dimming[seat] > 0.0]
    found = illuminate(scene, Luminaires=lamps, LampContributions=1, **properties)
    for lamp in lamps:
        simple.Delete(lamp)
    return found


def contribution(lamp):
    """The point array of a lamp's illuminance (lx); a surface that shines has no name of its own."""
    return "Illuminance_Lamp 1" if lamp == COVES else f"Illuminance_{lamp}"


def dimmed(found, dimming):
    """Illuminance (lx) at other levels than EVENING, which found is lit by: a Calculator, no tracing."""
    terms = [f'{level} * "{contribution(lamp)}"' for lamp, level in dimming.items()]
    properties = {"ResultArrayName": "Dimmed", "Function": " + ".join(terms)}
    surface = run_filter(simple.Calculator, found.surface, "Dimmed", properties)
    return vtk_to_numpy(surface.GetPointData().GetArray("Dimmed"))


def differ(found, fresh, dimming):
    """By how many standard errors dimmed(found) and a fresh run differ, root mean square over points.

    At most about 1 if both are right: lamps have photons of their own, so the variance of the dimmed
    map is at most that of the undimmed one as long as no level is above 1. Points with few photons
    are left out: their standard errors are too rough.
    """
    own = (fresh.array("RelativeError") < 0.2) & (fresh.array() > 0.0)
    variance = found.array("StandardError") ** 2 + fresh.array("StandardError") ** 2
    return np.sqrt(np.mean((dimmed(found, dimming) - fresh.array())[own] ** 2 / variance[own]))

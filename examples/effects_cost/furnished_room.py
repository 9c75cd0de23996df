# SPDX-License-Identifier: BSD-3-Clause
"""One furnished room whose parts Surface Material paints in different ways. Metres, z up."""

import sys
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import vtk
from paraview import simple

EXAMPLES = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(EXAMPLES / "common"), str(EXAMPLES / "accuracy_and_time")]

import bodies  # noqa: E402
from illumination import as_source  # noqa: E402
from scenes import wall, with_cell_value  # noqa: E402

FLOOR, END, WALLS, BALL, SHADE, SCREEN = range(6)  # values of the cell array Part
LAMP = (-1.0, 0.0, 0.3)
SHADE_RADIUS, SHADE_HEIGHT = 0.25, 0.4
# Effects -> the properties of Illumination Map that leave them out.
SWITCHES = {
    "compensation": {"Registration": "Flat"},
    "interreflection": {"Interreflection": 0},
    "colour": {"Colour": 0},
    "specular reflection": {"SpecularReflection": 0},
    "glossy reflection": {"GlossyReflection": 0},
    "diffuse transmission": {"DiffuseTransmission": 0},
    "clear transmission": {"ClearTransmission": 0},
    "refraction": {"Refraction": 0},
    "lamps kept apart": {"LampContributions": 0},
}
PAINT = {WALLS: {"Preset": "White Paint"}, FLOOR: {"Preset": "Mid Grey"}}
FURNISHINGS = {
    "colour": {
        FLOOR: {"Preset": "Wood"},
        END: {"DiffuseReflectance": [0.6, 0.1, 0.08]},
    },
    "metal": {END: {"Preset": "Mirror"}, BALL: {"Preset": "Aluminium"}},
    "shade": {SHADE: {"Preset": "Fabric"}},
    "glass": {
        SCREEN: {"Preset": "Clear Glass"},
        BALL: {
            "DiffuseReflectance": [0.0] * 3,
            "ClearTransmittance": [0.95] * 3,
            "RefractiveIndex": 1.5,
            "SolidBody": 1,
        },
    },
}


@dataclass
class Room:
    """What Illumination Map is given."""

    title: str
    effects: tuple  # those it is there to show: lines of the array Effects, up to the colon
    materials: dict  # part -> properties of Surface Material, besides PAINT
    lamps: list = field(default_factory=list)  # properties of Luminaires besides the shade's
    properties: dict = field(default_factory=dict)  # of Illumination Map


def ball():
    """In the middle of the room, fine enough to bend light like a ball."""
    source = vtk.vtkSphereSource()
    source.SetCenter(0.6, 0.0, -0.5)
    source.SetRadius(0.5)
    source.SetThetaResolution(48)
    source.SetPhiResolution(25)
    source.Update()
    return source.GetOutput()


def shade(around=32, along=4):
    """An open tube about the lamp."""
    angle = 2.0 * np.pi * np.arange(around) / around
    normals = np.stack([np.cos(angle), np.sin(angle), np.zeros(around)], axis=1)
    heights = SHADE_HEIGHT * (np.arange(along + 1) / along - 0.5)
    up = np.array([0.0, 0.0, 1.0])
    points = np.concatenate([SHADE_RADIUS * normals + h * up + LAMP for h in heights])
    j = np.arange(around)
    following = (j + 1) % around
    triangles = []
    for low in around * np.arange(along):
        high = low + around
        triangles.append(np.stack([low + j, low + following, high + following], axis=1))
        triangles.append(np.stack([low + j, high + following, high + j], axis=1))
    return bodies.to_surface(points, np.tile(normals, (along + 1, 1)), np.concatenate(triangles))


def screen(cells=16):
    """Stands across the room between lamp and ball, open above and at its sides."""
    y, z = np.meshgrid(np.linspace(-1.0, 1.0, cells + 1), np.linspace(-1.2, 0.6, cells + 1))
    points = np.stack([np.full(y.size, -0.3), y.ravel(), z.ravel()], axis=1)
    i, j = (n.ravel() for n in np.meshgrid(np.arange(cells), np.arange(cells)))
    a = i + (cells + 1) * j
    c = a + cells + 1
    triangles = np.concatenate([np.stack([a, c + 1, a + 1], 1), np.stack([a, c, c + 1], 1)])
    return bodies.to_surface(points, np.tile([-1.0, 0.0, 0.0], (len(points), 1)), triangles)


def surface():
    """All parts as one vtkPolyData with the cell array Part."""
    parts = [(FLOOR, wall(2, -1.0)), (END, wall(0, 1.0)), (WALLS, wall(2, 1.0))]
    parts += [(WALLS, wall(0, -1.0)), (WALLS, wall(1, -1.0)), (WALLS, wall(1, 1.0))]
    parts += [(BALL, ball()), (SHADE, shade()), (SCREEN, screen())]
    for _, part in parts:
        part.GetPointData().SetTCoords(None)
    numbered = (with_cell_value(part, "Part", float(number)) for number, part in parts)
    return bodies.appended(*numbered)


class Pipeline:
    """The room as a pipeline of ParaView: surface, Surface Materials, Luminaires."""

    def __init__(self, room):
        self.proxies = [as_source(surface())]
        for part, properties in {**PAINT, **room.materials}.items():
            self.proxies.append(
                simple.SurfaceMaterial(
                    Input=self.proxies[-1], CellArray="Part", CellValue=float(part), **properties
                )
            )
        self.surface = self.proxies[-1]
        lamps = [{"LuminaireName": "shade", "Type": "Point", "Position": LAMP}, *room.lamps]
        self.lamps = [simple.Luminaire(**lamp) for lamp in lamps]
        self.properties = room.properties

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for proxy in [*self.lamps, *reversed(self.proxies)]:
            simple.Delete(proxy)

    def map(self, **properties):
        """A new Illumination Map of it. Light inside an opaque shade falls on backs, as meant."""
        settings = {"RegisterBackSide": 1, **self.properties, **properties}
        return simple.IlluminationMap(Input=self.surface, Luminaires=self.lamps, **settings)


def rooms():
    """All rooms, from the plainest on."""
    spot = {
        "LuminaireName": "spot",
        "Type": "Spot",
        "Position": [1.5, 1.0, 1.1],
        "Direction": [-0.9, -1.0, -1.6],
        "SpotHalfAngle": 20.0,
        "LuminousFlux": 400.0,
        "LightColour": [1.0, 0.8, 0.6],
    }
    tube = {
        "LuminaireName": "tube",
        "Type": "Line",
        "Position": [0.0, -1.3, 1.1],
        "Direction": [1.0, 0.0, 0.0],
        "Size": [1.5, 1.0],
        "LuminousFlux": 600.0,
    }
    everything = {**FURNISHINGS["colour"], **FURNISHINGS["shade"], **FURNISHINGS["glass"]}
    everything.update({END: {"Preset": "Mirror"}, WALLS: {"Preset": "Aluminium"}})
    return [
        Room("White and grey paint", ("compensation", "interreflection"), {}),
        Room("Wooden floor, red wall", ("colour",), FURNISHINGS["colour"]),
        Room(
            "Mirror wall, aluminium ball",
            ("specular reflection", "glossy reflection"),
            FURNISHINGS["metal"],
        ),
        Room("Fabric lamp shade", ("diffuse transmission",), FURNISHINGS["shade"]),
        Room(
            "Glass screen, glass ball",
            ("clear transmission", "refraction"),
            FURNISHINGS["glass"],
        ),
        Room(
            "All of it, three lamps",
            tuple(SWITCHES),
            everything,
            [spot, tube],
            {"LampContributions": 1},
        ),
    ]

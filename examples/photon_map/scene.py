# SPDX-License-Identifier: BSD-3-Clause
"""A coarse black sphere that receives nothing but the light that a disk reflects. Metres, z up."""

from dataclasses import dataclass

import numpy as np
import vtk
from paraview import servermanager, simple
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import bodies
from illumination import as_source
from light_from_disk import Disk, Spot, illuminance, spot_on_disk

TO_SPHERE = np.array([0.80, 0.08, 0.52])
TO_SPHERE /= np.linalg.norm(TO_SPHERE)
CENTRE, RADIUS = np.zeros(3), 0.5  # of the sphere
DISK = Disk(CENTRE - 1.3 * TO_SPHERE, normal=TO_SPHERE, radius=0.8, reflectance=0.9)
# The lamp hangs between disk and sphere and shines at the disk only; a lamp casts no shadow.
SPOT = Spot(CENTRE - 0.75 * TO_SPHERE, direction=-TO_SPHERE, half_angle=52.0, flux=2000.0)
ALL_HITS = 3  # a photon; there are at most two


def coarse_sphere():
    """80 flat facets, each in 16 triangles whose points have the smooth sphere's normals."""
    divide = vtk.vtkLinearSubdivisionFilter()
    divide.SetInputData(bodies.icosphere(CENTRE, RADIUS, 1))
    divide.SetNumberOfSubdivisions(2)
    divide.Update()
    places = points(divide.GetOutput())
    normals = (places - CENTRE) / np.linalg.norm(places - CENTRE, axis=1, keepdims=True)
    return bodies.to_surface(places, normals, corners(divide.GetOutput()))


def corners(surface):
    """The points of a vtkPolyData's triangles, (triangles, 3)."""
    return vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def whole_scene(sphere):
    """The sphere, and the disk after it; cell array Reflectance."""
    across = np.cross(DISK.normal, (0.0, 1.0, 0.0))
    across *= DISK.radius / np.linalg.norm(across)
    whole = bodies.appended(sphere, bodies.disk(DISK.centre, DISK.normal, across, 96, 8))
    reflectance = np.zeros(whole.GetNumberOfCells())
    reflectance[sphere.GetNumberOfCells() :] = DISK.reflectance
    array = numpy_to_vtk(reflectance, deep=1)
    array.SetName("Reflectance")
    whole.GetCellData().AddArray(array)
    return whole


def exact_illuminance(sphere):
    """Illuminance (lx) of the sphere's points as far as their own normals see, by quadrature."""
    return illuminance(*bodies.points_and_normals(sphere), DISK, spot_on_disk(SPOT, DISK))


@dataclass
class Lit:
    """What one run of Illumination Map gives."""

    surface: object  # vtkPolyData with the map
    photons: object  # vtkPolyData with a vertex a hit, of all photons
    paths: object  # vtkPolyData with a polyline for each of the first photons


def lit(surface, photons, paths=0, **properties):
    """Lights a scene by so many photons and stores all of their hits."""
    proxy = simple.IlluminationMap(
        Input=as_source(surface),
        ReflectanceArray="Reflectance",
        Photons=photons,
        MaximumPhotons=ALL_HITS * photons,
        PhotonPaths=paths,
        **SPOT.properties(),
        **properties,
    )
    proxy.UpdatePipeline()
    outputs = [servermanager.Fetch(proxy, idx=port) for port in (0, 2, 3)]
    simple.Delete(proxy)
    return Lit(*outputs)


def array(data, name):
    """A point array of a data set."""
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def points(data):
    """The points of a data set in double precision, (points, 3)."""
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)

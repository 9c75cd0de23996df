# SPDX-License-Identifier: BSD-3-Clause
"""A lit surface as arrays of triangles. Lengths in the data's unit."""

from dataclasses import dataclass

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkCompositeDataSet, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

ILLUMINANCE = ("IlluminanceSmoothed", "Illuminance")  # point arrays, lx; the first that is there


@dataclass
class LitTriangles:
    """Triangles with the light that arrives at their corners."""

    name: str
    mesh: vtkPolyData  # with all arrays; of its triangles those count that corners tell
    array: str  # of ILLUMINANCE
    points: np.ndarray  # (n, 3)
    normals: np.ndarray  # (n, 3), of any length; zeros where the data have none
    corners: np.ndarray  # (m, 3), indices of points, of triangles with an area
    illuminance: np.ndarray  # (n,), lx

    def only(self, chosen):
        """The triangles that are chosen: (m,) of bool. Cell arrays are left out."""
        corners = self.corners[chosen]
        mesh = vtkPolyData()
        mesh.SetPoints(self.mesh.GetPoints())
        mesh.GetPointData().ShallowCopy(self.mesh.GetPointData())
        triangles = vtkCellArray()
        offsets = np.arange(0, corners.size + 1, 3)
        triangles.SetData(*(numpy_to_vtkIdTypeArray(a, deep=1) for a in (offsets, corners.ravel())))
        mesh.SetPolys(triangles)
        return LitTriangles(
            self.name, mesh, self.array, self.points, self.normals, corners, self.illuminance)  # fmt: skip

    def area_vectors(self):
        """(m, 3): as long as the area, along the side from which corners run counter-clockwise."""
        a, b, c = self.points[self.corners].transpose(1, 0, 2)
        return 0.5 * np.cross(b - a, c - a)


def _blocks(data):
    """The vtkPolyData of a data object, with names."""
    if isinstance(data, vtkPolyData):
        return [("Surface", data)]
    found = []
    if isinstance(data, vtkCompositeDataSet):
        iterator = data.NewIterator()
        iterator.InitTraversal()
        while not iterator.IsDoneWithTraversal():
            block = iterator.GetCurrentDataObject()
            if isinstance(block, vtkPolyData):
                known = iterator.HasCurrentMetaData()
                name = iterator.GetCurrentMetaData().Get(vtkCompositeDataSet.NAME()) if known else None
                found.append((name or f"Block {iterator.GetCurrentFlatIndex()}", block))
            iterator.GoToNextItem()
    return found


def _triangles_of(block):
    """The polygons and strips of a vtkPolyData as triangles, with all arrays."""
    triangulate = vtkTriangleFilter()
    triangulate.PassVertsOff()
    triangulate.PassLinesOff()
    triangulate.SetInputData(block)
    triangulate.Update()
    return triangulate.GetOutput()


def lit_triangles(data):
    """LitTriangles of each vtkPolyData of a data object that has an illumination map."""
    blocks = _blocks(data)
    present = (n for n in ILLUMINANCE if any(b.GetPointData().HasArray(n) for _, b in blocks))
    array = next(present, None)
    result = []
    for name, block in blocks:
        if array is None or not block.GetPointData().HasArray(array):
            continue
        mesh = _triangles_of(block)
        if mesh.GetNumberOfPolys() == 0:
            continue
        points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
        normals = mesh.GetPointData().GetNormals()
        surface = LitTriangles(
            name,
            mesh,
            array,
            points,
            vtk_to_numpy(normals).astype(float) if normals else np.zeros_like(points),
            vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3),
            vtk_to_numpy(mesh.GetPointData().GetArray(array)).astype(float),
        )
        has_area = np.linalg.norm(surface.area_vectors(), axis=1) > 0.0
        surface.corners = surface.corners[has_area]
        result.append(surface)
    return result


def facet_error(surfaces):
    """The root mean square of FacetError by area, over the mean illuminance; None where it is not told."""
    area, light, square = 0.0, 0.0, 0.0
    for surface in surfaces:
        array = surface.mesh.GetPointData().GetArray("FacetError")
        if array is None:
            return None
        own = np.linalg.norm(surface.area_vectors(), axis=1)
        area += own.sum()
        light += np.sum(own * surface.illuminance[surface.corners].mean(axis=1))
        square += np.sum(own * (vtk_to_numpy(array)[surface.corners] ** 2).mean(axis=1))
    return np.sqrt(square * area) / light if light > 0.0 else None


def part_names(data, array):
    """Names of parts by number: the field array <array>Names, such as PartNames; else empty."""
    names = data.GetFieldData().GetAbstractArray(f"{array}Names")
    blocks = [] if names else [block for _, block in _blocks(data)]
    for block in blocks:
        names = names or block.GetFieldData().GetAbstractArray(f"{array}Names")
    return [names.GetVariantValue(i).ToString() for i in range(names.GetNumberOfValues())] if names else []

# SPDX-License-Identifier: BSD-3-Clause
"""Models of which each rank has a piece, for rank_scenes.py and rank_stops.py."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from vtkIllumination import vtkIlluminationMap, vtkLuminaireSource

CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK = CONTROLLER.GetLocalProcessId() if CONTROLLER else 0
RANKS = CONTROLLER.GetNumberOfProcesses() if CONTROLLER else 1

# ---- models: points, normals, cells (corners), arrays by name


def wall(origin, first, second, cells):
    """A grid of squares; its front is where first x second looks."""
    steps = np.linspace(0.0, 1.0, cells + 1)
    u, v = np.meshgrid(steps, steps, indexing="ij")
    points = origin + u.reshape(-1, 1) * np.array(first) + v.reshape(-1, 1) * np.array(second)
    normal = np.cross(first, second)
    normals = np.tile(normal / np.linalg.norm(normal), (len(points), 1))
    at = lambda i, j: i * (cells + 1) + j  # noqa: E731
    corners = [(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)) for i in range(cells) for j in range(cells)]
    return points, normals, corners


def ball(centre, radius, rows):
    """A sphere of triangles with exact normals."""
    around = 2 * rows
    normals = [(0.0, 0.0, 1.0)]
    for i in range(1, rows):
        for j in range(around):
            polar, azimuth = np.pi * i / rows, 2 * np.pi * j / around
            normals.append((np.sin(polar) * np.cos(azimuth), np.sin(polar) * np.sin(azimuth), np.cos(polar)))
    normals.append((0.0, 0.0, -1.0))
    at = lambda i, j: 1 + (i - 1) * around + j % around  # noqa: E731
    corners = []
    for j in range(around):
        corners.append((0, at(1, j), at(1, j + 1)))
        corners.append((len(normals) - 1, at(rows - 1, j + 1), at(rows - 1, j)))
        for i in range(1, rows - 1):
            corners += [(at(i, j), at(i + 1, j), at(i + 1, j + 1)), (at(i, j), at(i + 1, j + 1), at(i, j + 1))]
    return np.array(centre) + radius * np.array(normals), np.array(normals), corners


def together(parts):
    points, normals, corners = [], [], []
    for p, n, c in parts:
        first = sum(len(q) for q in points)
        corners += [tuple(first + i for i in cell) for cell in c]
        points.append(p)
        normals.append(n)
    return np.concatenate(points), np.concatenate(normals), corners


def room(cells=4):
    """A closed room with a ball, in colours; some of it shines like a mirror."""
    x, y, z = np.eye(3)
    model = together([wall(0 * x, x, y, cells), wall(z, y, x, cells), wall(0 * x, y, z, cells), wall(x, z, y, cells),
                      wall(0 * x, z, x, cells), wall(y, x, z, cells), ball((0.6, 0.5, 0.3), 0.2, 6)])
    middles = np.array([model[0][list(cell)].mean(axis=0) for cell in model[2]])
    mirror = np.where(middles[:, 0] > 0.9, 0.3, 0.0)
    arrays = {"DiffuseReflectance": 0.2 + 0.4 * middles, "SpecularReflectance": mirror,
              "Region": (middles[:, 2] < 0.5).astype(float)}
    return model, arrays


# ---- pieces


def owners(cells, how):
    """[cell] The rank that has it."""
    numbers = np.arange(cells)
    if how == "scattered":
        return numbers * 2654435761 % 2**32 // 7 % RANKS
    if how == "hole":  # the middle rank has nothing
        return np.where(numbers % 2, 0, RANKS - 1)
    if how == "last":
        return np.full(cells, RANKS - 1)
    return numbers * RANKS // cells


def poly_data(points, normals, corners, arrays):
    data = vtkPolyData()
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    data.SetPoints(vtk_points)
    cells = vtkCellArray()
    flat = np.array([i for cell in corners for i in (len(cell), *cell)], dtype=np.int64)
    cells.ImportLegacyFormat(numpy_to_vtkIdTypeArray(flat, deep=True))
    data.SetPolys(cells)
    if normals is not None:
        array = numpy_to_vtk(np.ascontiguousarray(normals), deep=True)
        array.SetName("Normals")
        data.GetPointData().SetNormals(array)
    for name, values in arrays.items():
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        array.SetName(name)
        data.GetCellData().AddArray(array)
    return data


def piece(model, arrays, how="ranges", rank=None, with_normals=True):
    """This rank's cells and their points, which have another order on each rank."""
    rank = RANK if rank is None else rank
    points, normals, corners = model
    own = np.flatnonzero(owners(len(corners), how) == rank)
    used = np.unique([i for cell in own for i in corners[cell]]).astype(int)
    if rank % 2:
        used = used[::-1]
    number = {point: i for i, point in enumerate(used)}
    return poly_data(points[used], normals[used] if with_normals else None,
                     [tuple(number[i] for i in corners[cell]) for cell in own],
                     {name: values[own] for name, values in arrays.items()})


def lamp(position, name, kind="POINT", on_rank=0):
    """A luminaire, as a source is: on one rank only."""
    if RANK != on_rank % RANKS:
        return vtkPolyData()
    source = vtkLuminaireSource()
    source.SetType(getattr(source, kind))
    source.SetPosition(position)
    source.SetLuminaireName(name)
    source.Update()
    return source.GetOutput()


def set_all(result, properties):
    for name, value in properties.items():
        getattr(result, "Set" + name)(value)


def illumination_map(surface, luminaires=(), threads=1, **properties):
    result = vtkIlluminationMap()
    result.SetInputDataObject(surface)
    for luminaire in luminaires:
        result.AddInputDataObject(1, luminaire)
    result.SetNumberOfThreads(threads)
    result.SetLampType(result.POINT)
    result.SetLampPosition(0.3, 0.4, 0.9)
    set_all(result, properties)
    return result


def fields(result):
    """Field data and the table, but for how long it took and what memory it needed."""
    data = result.GetOutputDataObject(0).GetFieldData()
    tables = [data]
    if result.GetNumberOfOutputPorts() > 1:
        tables.append(result.GetOutputDataObject(1).GetRowData())
    found = []
    for table in tables:
        for i in range(table.GetNumberOfArrays()):
            array = table.GetAbstractArray(i)
            if "Second" not in array.GetName() and array.GetName() != "MemoryNeeded":  # which threads add to
                found.append([array.GetName(), [str(array.GetVariantValue(j)) for j in
                                                range(array.GetNumberOfValues())]])
    return found

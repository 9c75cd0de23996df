// SPDX-License-Identifier: BSD-3-Clause
// The polygonal blocks of a data object, and what their meshes consist of.
#ifndef SurfaceParts_h
#define SurfaceParts_h

#include <glm/vec3.hpp>

#include <cstddef>
#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace Illumination
{

struct NamedSurface
{
  vtkPolyData* data;
  std::string name;    ///< For messages: " of block 2", or "" where there is only one.
  unsigned number = 0; ///< Of the block: its flat index.
};

struct SurfaceParts
{
  std::vector<NamedSurface> surfaces;
  std::size_t others = 0; ///< Blocks that are no vtkPolyData.
};

/// @param data A vtkPolyData or a composite data set.
SurfaceParts PartsOf(vtkDataObject* data);

/// The points of a mesh of triangles, behind those that are there.
void AppendPoints(vtkPolyData* mesh, std::vector<glm::dvec3>& points);
/// Its point normals; zero where it has none.
void AppendNormals(vtkPolyData* mesh, std::vector<glm::dvec3>& normals);
/// Its triangles. @param firstPoint The number that point 0 of the mesh has.
void AppendFacets(vtkPolyData* mesh, std::size_t firstPoint, std::vector<glm::uvec3>& facets);

} // namespace Illumination

#endif

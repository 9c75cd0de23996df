// SPDX-License-Identifier: BSD-3-Clause
#ifndef MapBlocks_h
#define MapBlocks_h

#include "Illumination/surface/SurfaceParts.h"

#include "PhotonTransport/statistics/GroupMeans.h"

#include "vtkType.h"

#include <glm/vec3.hpp>

#include <functional>
#include <string>
#include <utility>
#include <vector>

class vtkDataArray;
class vtkDataObject;

namespace Illumination
{

/// The polygonal blocks of a data object as one list of points with their triangles
/// (SurfaceTriangles), and the point arrays on them. Those points that triangles have are the
/// vertices of the map; their order does not depend on how the surface is divided between ranks
/// (OrderedByPlace).
class MapBlocks
{
public:
  struct Block : NamedSurface
  {
    std::size_t firstPoint;
  };

  /// Throws InputError. @param data A vtkPolyData or a composite data set; must outlive this.
  explicit MapBlocks(vtkDataObject* data);

  const std::vector<Block>& Blocks() const { return this->Parts; }
  const std::vector<glm::dvec3>& Vertices() const { return this->Places; }
  const std::vector<glm::uvec3>& Facets() const { return this->AllFacets; }
  /// "point 7 of block 2".
  std::string NameOfVertex(std::size_t vertex) const;

  /// @param values [point] @return [vertex]
  template <typename Value>
  std::vector<Value> OfVertices(const std::vector<Value>& values) const
  {
    std::vector<Value> chosen;
    for (const std::size_t point : this->PointOfVertex)
    {
      chosen.push_back(values[point]);
    }
    return chosen;
  }
  /// @param values [vertex] @param others [point] Of points that no triangle has; empty: 0.
  /// @return [point]
  template <typename Value>
  std::vector<Value> OfPoints(
    const std::vector<Value>& values, std::vector<Value> others = {}) const
  {
    others.resize(this->NumberOfPoints, Value{});
    for (std::size_t v = 0; v < values.size(); ++v)
    {
      others[this->PointOfVertex[v]] = values[v];
    }
    return others;
  }

  /// Gives each ghost point the value of its owner. @param values [point]
  template <typename Value>
  void CopyToGhosts(std::vector<Value>& values) const
  {
    for (const auto& [ghost, owner] : this->OwnerOfGhost)
    {
      values[ghost] = values[owner];
    }
  }

  /// Whether all blocks have a point array of the name.
  bool Have(const std::string& array) const;
  /// The values of a point array, one number a point. Throws InputError if a block has no such
  /// array.
  std::vector<double> Values(const std::string& array) const;
  /// The same for an array with one component for each group.
  std::vector<PhotonTransport::GroupValues> Groups(const std::string& array) const;

  /// Calls f(block, its part of `values`) for each block.
  template <typename Value, typename Function>
  void ForEachPart(const std::vector<Value>& values, const Function& f) const
  {
    for (std::size_t b = 0; b < this->Parts.size(); ++b)
    {
      const auto first = static_cast<std::ptrdiff_t>(this->Parts[b].firstPoint);
      const auto last = static_cast<std::ptrdiff_t>(
        b + 1 < this->Parts.size() ? this->Parts[b + 1].firstPoint : values.size());
      f(this->Parts[b], std::vector<Value>(values.begin() + first, values.begin() + last));
    }
  }

private:
  void Append(const NamedSurface& part);
  void FindOwners();
  void ForEachTuple(const std::string& array, int components,
    const std::function<void(std::size_t point, vtkDataArray* array, vtkIdType tuple)>& f) const;

  std::vector<Block> Parts;
  std::size_t NumberOfPoints = 0;
  std::vector<std::size_t> PointOfVertex;
  std::vector<glm::dvec3> Places;
  std::vector<glm::uvec3> AllFacets;
  std::vector<std::pair<std::size_t, std::size_t>> OwnerOfGhost; ///< Of points.
};

} // namespace Illumination

#endif

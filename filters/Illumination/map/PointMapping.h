// SPDX-License-Identifier: BSD-3-Clause
#ifndef PointMapping_h
#define PointMapping_h

#include "Illumination/pipeline/FieldArrays.h"
#include "Illumination/surface/SceneBlock.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

namespace Illumination
{

/// Carries values from the scene's vertices to a block's points. A point whose normals were split
/// has several vertices and gets their mean, weighted by area, which keeps the flux, sum A E. A
/// ghost point has the vertices of its owner.
class PointMapping
{
public:
  PointMapping(const SceneBlock& block, const std::vector<double>& vertexAreas)
    : Block(block)
    , VertexAreas(vertexAreas)
    , Areas(static_cast<std::size_t>(block.data->GetNumberOfPoints()), 0.0)
  {
    this->ForEach([&](std::size_t vertex, std::size_t point)
      { this->Areas[point] += this->VertexAreas[vertex]; });
  }

  /// The block's own.
  vtkPointData* PointArrays() const { return this->Block.data->GetPointData(); }

  /// Calls f(vertex of the scene, point of the block).
  template <typename Function>
  void ForEach(const Function& f) const
  {
    for (std::size_t v = 0; v < this->Block.pointOfVertex.size(); ++v)
    {
      const auto point = static_cast<std::size_t>(this->Block.pointOfVertex[v]);
      if (this->Block.borrows.empty() || !this->Block.borrows[point])
      {
        f(this->Block.firstVertex + v, point);
      }
    }
    for (const BorrowedVertex& borrowed : this->Block.borrowed)
    {
      f(borrowed.vertex, borrowed.point);
    }
  }

  /// @param values By vertex: numbers, or arrays of numbers.
  template <typename Value>
  std::vector<Value> Mean(const std::vector<Value>& values) const
  {
    std::vector<Value> mean(this->Areas.size(), Value{});
    this->ForEachShare(
      [&](std::size_t vertex, std::size_t point, double share)
      {
        if constexpr (std::is_same_v<Value, double>)
        {
          mean[point] += values[vertex] * share;
        }
        else
        {
          std::transform(values[vertex].begin(), values[vertex].end(), mean[point].begin(),
            mean[point].begin(), [&](double value, double sum) { return sum + value * share; });
        }
      });
    return mean;
  }

  /// The standard error of Mean(), if the noise of a point's vertices is independent.
  std::vector<double> MeanError(const std::vector<double>& errors) const
  {
    std::vector<double> error(this->Areas.size(), 0.0);
    this->ForEachShare([&](std::size_t vertex, std::size_t point, double share)
      { error[point] = std::hypot(error[point], errors[vertex] * share); });
    return error;
  }

private:
  /// Calls f(vertex, point, its share in the point's area) where there is an area.
  template <typename Function>
  void ForEachShare(const Function& f) const
  {
    this->ForEach(
      [&](std::size_t vertex, std::size_t point)
      {
        if (this->Areas[point] > 0.0)
        {
          f(vertex, point, this->VertexAreas[vertex] / this->Areas[point]);
        }
      });
  }

  const SceneBlock& Block;
  const std::vector<double>& VertexAreas;
  std::vector<double> Areas;
};

/// Adds a point array to all blocks. @param values By vertex of the scene.
template <typename Value>
void AddMean(const std::vector<PointMapping>& mappings, const std::string& name,
  const std::vector<Value>& values)
{
  for (const PointMapping& mapping : mappings)
  {
    AddArray(mapping.PointArrays(), name.c_str(), mapping.Mean(values));
  }
}

} // namespace Illumination

#endif

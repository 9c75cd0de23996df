// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/refinement/RefinedPoints.h"

#include "vtkPolyData.h"

namespace Illumination
{

std::size_t AddedPoint::Nearest() const
{
  int best = 0;
  for (int i = 1; i < 3; ++i)
  {
    const double more = this->weights[i] - this->weights[best];
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(best);
    if (more > 0.0 || (more == 0.0 && this->vertices[a] < this->vertices[b]))
    {
      best = i;
    }
  }
  return this->vertices[static_cast<std::size_t>(best)];
}

RefinedPoints::RefinedPoints(
  const RefinementBlock& block, const FinePart& part, std::vector<vtkIdType>& idOfFinePoint)
  : Given(block.data->GetNumberOfPoints())
{
  const glm::dvec3 first(1.0, 0.0, 0.0);
  std::vector<bool> met(static_cast<std::size_t>(this->Given), false);
  for (std::size_t v = 0; v < block.pointOfVertex.size(); ++v)
  {
    const vtkIdType point = block.pointOfVertex[v];
    const std::size_t vertex = block.firstVertex + v;
    idOfFinePoint[vertex] = met[static_cast<std::size_t>(point)]
      ? this->Add({ part.mesh.points[vertex], { vertex, vertex, vertex }, first, true })
      : point;
    met[static_cast<std::size_t>(point)] = true;
  }
  for (std::size_t f = part.first; f < part.end; ++f)
  {
    const PhotonTransport::FacetOrigin& origin = part.fine.origins[f];
    const glm::uvec3& corners = part.mesh.facets[origin.facet];
    for (int i = 0; i < 3; ++i)
    {
      const std::uint32_t point = part.fine.facets[f][i];
      if (idOfFinePoint[point] < 0)
      {
        idOfFinePoint[point] =
          this->Add({ part.fine.points[point], { corners.x, corners.y, corners.z },
            glm::dvec3(origin.corners[static_cast<std::size_t>(i)]), false });
      }
    }
  }
}

vtkIdType RefinedPoints::Add(const AddedPoint& point)
{
  this->Points.push_back(point);
  return this->Number() - 1;
}

} // namespace Illumination

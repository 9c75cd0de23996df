// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/gathering/VertexReceivers.h"

#include <algorithm>

namespace PhotonTransport
{
namespace
{

/// How far within a facet rays start: this share of the way to its middle, or of a cell.
constexpr float Within = 3e-3f;

FacetRings RingsOfMap(const Scene& scene)
{
  return { scene.NumberOfMapVertices(), scene.Facets().size(),
    [&](std::size_t f)
    {
      glm::uvec3 ids = scene.Facets()[f].vertices;
      for (int c = 0; c < 3; ++c)
      {
        ids[c] = ids[c] < scene.NumberOfMapVertices() ? ids[c] : NoVertex;
      }
      return ids;
    } };
}

} // namespace

VertexReceivers::VertexReceivers(const Scene& scene, const FacetCells& cells)
  : LitScene(scene)
  , Cells(cells)
  , FacetsAround(RingsOfMap(scene))
{
}

void VertexReceivers::Make(std::uint32_t vertex, bool front, Receiver& receiver) const
{
  const Vertex& record = this->LitScene.Vertices()[vertex];
  receiver.normal = front ? record.normal : -record.normal;
  receiver.position = record.position;
  receiver.starts.clear();
  // Without a normal nothing is lit. It would be a point in free space, which light of all
  // directions reaches.
  if (!(this->LitScene.VertexAreas()[vertex] > 0.0) || record.normal == glm::vec3(0.0f))
  {
    return;
  }
  for (const std::uint32_t f : this->FacetsAround.Of(vertex))
  {
    const Facet& facet = this->LitScene.Facets()[f];
    glm::vec3 into = -record.position;
    for (int c = 0; c < 3; ++c)
    {
      into += (1.0f / 3.0f) * this->LitScene.Vertices()[facet.vertices[c]].position;
    }
    const float length = glm::length(into);
    const float within =
      Within * (length > 0.0f ? std::min(1.0f, this->Cells.Length(f) / length) : 1.0f);
    glm::vec3 barycentric(within / 3.0f);
    for (int c = 0; c < 3; ++c)
    {
      if (facet.vertices[c] == vertex)
      {
        barycentric[c] = 1.0f - within * 2.0f / 3.0f;
      }
    }
    receiver.starts.push_back({ this->LitScene.SafeOrigin(f, barycentric, front),
      front ? facet.normal : -facet.normal, length > 0.0f ? into / length : glm::vec3(0.0f) });
  }
  receiver.SortStarts();
}

} // namespace PhotonTransport

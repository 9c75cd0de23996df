// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/adaptive/PlaceReceivers.h"

#include "PhotonTransport/scene/HitPoint.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace PhotonTransport
{
namespace
{

/// How far within a facet rays from its edges start: this share of the way to the middle of the
/// part, or of a cell.
constexpr float Within = 1e-3f;

/// The scene has the facets of the surface in their order, but for those without area.
std::vector<std::uint32_t> FindInScene(const Scene& scene, const Surface& surface)
{
  std::vector<std::uint32_t> found(surface.facets.size(), NoFacet);
  std::uint32_t next = 0;
  for (std::size_t f = 0; f < found.size() && next < scene.Facets().size(); ++f)
  {
    if (scene.Facets()[next].vertices == surface.facets[f])
    {
      found[f] = next++;
    }
  }
  return found;
}

} // namespace

PlaceReceivers::PlaceReceivers(const Scene& scene, const Surface& surface, const FacetCells& cells)
  : LitScene(scene)
  , Cells(cells)
  , SceneFacets(FindInScene(scene, surface))
{
}

void PlaceReceivers::Make(
  const std::vector<PlaceOnFacet>& places, bool front, Receiver& receiver) const
{
  receiver.starts.clear();
  for (const PlaceOnFacet& place : places)
  {
    const std::uint32_t f = this->SceneFacets[place.facet];
    if (f == NoFacet)
    {
      continue;
    }
    if (receiver.starts.empty())
    {
      receiver.normal = (front ? 1.0f : -1.0f) * this->NormalAt(f, place.barycentric);
      receiver.position = PointOf(this->LitScene, { f, place.barycentric });
      if (receiver.IsInFreeSpace()) // which is no place on a surface: see VertexReceivers
      {
        return;
      }
    }
    const glm::vec3& at = place.barycentric;
    const bool onEdge = at.x == 0.0f || at.y == 0.0f || at.z == 0.0f;
    receiver.starts.push_back(this->StartWithin(f, place, onEdge, front));
    if (!onEdge)
    {
      return; // the other parts that have the point are of the same facet
    }
  }
  receiver.SortStarts();
}

ReceiverStart PlaceReceivers::StartWithin(
  std::uint32_t sceneFacet, const PlaceOnFacet& place, bool onEdge, bool front) const
{
  const Facet& facet = this->LitScene.Facets()[sceneFacet];
  const glm::vec3 normal = front ? facet.normal : -facet.normal;
  if (!onEdge)
  {
    return { this->LitScene.SafeOrigin(sceneFacet, place.barycentric, front), normal };
  }
  const auto position = [&](int c)
  { return this->LitScene.Vertices()[facet.vertices[c]].position; };
  const glm::vec3 middle = (1.0f / 3.0f) * (place.part[0] + place.part[1] + place.part[2]);
  const glm::vec3 toMiddle = middle - place.barycentric;
  const glm::vec3 into =
    toMiddle.y * (position(1) - position(0)) + toMiddle.z * (position(2) - position(0));
  const float length = glm::length(into);
  if (!(length > 0.0f))
  {
    return { this->LitScene.SafeOrigin(sceneFacet, place.barycentric, front), normal };
  }
  const float share = Within * std::min(1.0f, this->Cells.Length(sceneFacet) / length);
  return { this->LitScene.SafeOrigin(sceneFacet, place.barycentric + share * toMiddle, front),
    normal, into / length };
}

glm::vec3 PlaceReceivers::NormalAt(std::uint32_t sceneFacet, const glm::vec3& barycentric) const
{
  const RegisteredPlace place = this->LitScene.PlaceOnGiven({ sceneFacet, barycentric });
  const glm::vec3 sum = place.barycentric.x * this->LitScene.Vertices()[place.vertices.x].normal +
    place.barycentric.y * this->LitScene.Vertices()[place.vertices.y].normal +
    place.barycentric.z * this->LitScene.Vertices()[place.vertices.z].normal;
  const float length = glm::length(sum);
  constexpr float Least = 1e-3f; // where the corners' normals all but cancel out
  return length > Least ? sum / length : this->LitScene.Facets()[sceneFacet].normal;
}

} // namespace PhotonTransport

// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/geometry/SharpEdges.h"

#include "PhotonTransport/geometry/FacetRings.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace PhotonTransport
{
namespace
{

/// The facets around one point, those with a normal.
class Ring
{
public:
  Ring(const std::vector<glm::uvec3>& facets, const std::vector<glm::vec3>& normals, float cosine)
    : Facets(facets)
    , Normals(normals)
    , Cosine(cosine)
    , CosineOfHalf(std::sqrt(0.5f + 0.5f * cosine))
  {
  }

  bool HasSharpEdge(std::uint32_t point, const Range<std::uint32_t>& ring)
  {
    this->Spokes.clear();
    for (const std::uint32_t f : ring)
    {
      if (this->Normals[f] != glm::vec3(0.0f))
      {
        this->AddSpokes(point, f);
      }
    }
    return !this->IsSmooth() && this->AnySharp();
  }

private:
  /// The other end of an edge, and a facet there.
  using Spoke = std::pair<std::uint32_t, std::uint32_t>;

  void AddSpokes(std::uint32_t point, std::uint32_t facet)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      if (this->Facets[facet][corner] != point)
      {
        this->Spokes.emplace_back(this->Facets[facet][corner], facet);
      }
    }
  }

  float CosineBetween(const Spoke& a, const Spoke& b) const
  {
    return glm::dot(this->Normals[a.second], this->Normals[b.second]);
  }

  /// No facet is farther than half the angle from the first, so no two are farther than all of it.
  bool IsSmooth() const
  {
    return std::all_of(this->Spokes.begin(), this->Spokes.end(),
      [&](const Spoke& spoke)
      { return this->CosineBetween(this->Spokes.front(), spoke) >= this->CosineOfHalf; });
  }

  /// Each facet of an edge against the first of them.
  bool AnySharp()
  {
    std::sort(this->Spokes.begin(), this->Spokes.end());
    const Spoke* first = nullptr;
    for (const Spoke& spoke : this->Spokes)
    {
      if (!first || first->first != spoke.first)
      {
        first = &spoke;
      }
      else if (this->CosineBetween(*first, spoke) < this->Cosine)
      {
        return true;
      }
    }
    return false;
  }

  const std::vector<glm::uvec3>& Facets;
  const std::vector<glm::vec3>& Normals;
  float Cosine;
  float CosineOfHalf;
  std::vector<Spoke> Spokes;
};

} // namespace

std::vector<std::uint8_t> PointsOnSharpEdges(std::size_t points,
  const std::vector<glm::uvec3>& facets, const std::vector<glm::vec3>& normals, float cosine)
{
  std::vector<std::uint8_t> sharp(points, 0);
  const FacetRings rings(points, facets);
  Ring ring(facets, normals, cosine);
  for (std::uint32_t p = 0; p < points; ++p)
  {
    sharp[p] = ring.HasSharpEdge(p, rings.Of(p));
  }
  return sharp;
}

} // namespace PhotonTransport

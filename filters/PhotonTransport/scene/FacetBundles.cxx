// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/FacetBundles.h"

#include <glm/geometric.hpp>

#include <cstddef>

namespace PhotonTransport
{
namespace
{

/// Whether any two facets of a group face the same way. In most groups no two do, and a look at a
/// small group is quick. Groups that are not small count as if two did.
bool AnyFaceTheSameWay(
  const std::vector<FacetPlane>& planes, const PlaneMember* first, const PlaneMember* last)
{
  constexpr std::ptrdiff_t Small = 8;
  if (last - first > Small)
  {
    return true;
  }
  for (const PlaneMember* one = first; one != last; ++one)
  {
    for (const PlaneMember* other = first; other != one; ++other)
    {
      if (FaceTheSameWay(planes, other->facet, one->facet))
      {
        return true;
      }
    }
  }
  return false;
}

} // namespace

std::vector<Bundle> BundlesOf(
  const std::vector<FacetPlane>& planes, const PlaneMember* first, const PlaneMember* last)
{
  constexpr float Joins = 0.9f;
  constexpr float AtHome = 0.95f; // all that face the same way as such a facet join its bundle
  std::vector<Bundle> bundles;
  if (!AnyFaceTheSameWay(planes, first, last))
  {
    return bundles;
  }
  for (; first != last; ++first)
  {
    const glm::vec3& normal = planes[first->facet].normal;
    bool atHome = false;
    for (Bundle& bundle : bundles)
    {
      const float cosine = glm::dot(normal, bundle.normal);
      atHome = atHome || cosine > AtHome;
      if (cosine > Joins)
      {
        bundle.facets.push_back(first->facet);
      }
    }
    if (!atHome)
    {
      bundles.push_back({ normal, { first->facet } });
    }
  }
  return bundles;
}

} // namespace PhotonTransport

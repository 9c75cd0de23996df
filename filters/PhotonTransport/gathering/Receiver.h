// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <tuple>
#include <vector>

namespace PhotonTransport
{

/// A place on one facet around a receiver where rays start, clear of the facet; see
/// Scene::SafeOrigin.
struct ReceiverStart
{
  glm::vec3 origin;
  glm::vec3 normal;         ///< Unit, of the facet, on the receiver's side.
  glm::vec3 inward{ 0.0f }; ///< Unit, from the receiver into the facet; zero in its middle.
};

/// A point that receives light on one side of the surface, or in free space from everywhere.
struct Receiver
{
  /// Unit, on that side: light counts by its cosine to it. Zero in free space, where light of all
  /// directions counts alike.
  glm::vec3 normal;
  std::vector<ReceiverStart> starts; ///< One on each facet around it.
  glm::vec3 position{ 0.0f };        ///< The point itself, for lamps without an extent.

  bool IsInFreeSpace() const { return this->normal == glm::vec3(0.0f); }

  /// Gives the starts an order that follows from their places. In that of the facets, what comes
  /// first, and how sums are rounded, would depend on the order of the input.
  void SortStarts()
  {
    const auto before = [](const ReceiverStart& a, const ReceiverStart& b)
    {
      const glm::vec3& p = a.origin;
      const glm::vec3& q = b.origin;
      return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
    };
    std::sort(this->starts.begin(), this->starts.end(), before);
  }

  /// Where the receiver is for lamps and openings that have an extent: in the middle of its starts,
  /// of which there must be one. At a vertex in the edge of a wall that shines this place sees the
  /// wall. The vertex itself, which lies in the wall's plane, would see nothing of it.
  glm::dvec3 Middle() const
  {
    glm::dvec3 sum(0.0);
    for (const ReceiverStart& start : this->starts)
    {
      sum += glm::dvec3(start.origin);
    }
    return sum / static_cast<double>(this->starts.size());
  }

  /// By how much light from a direction counts; not above 0 if it does not. @param direction Unit.
  float Counts(const glm::vec3& direction) const
  {
    return this->IsInFreeSpace() ? 1.0f : glm::dot(direction, this->normal);
  }

  /// Where a ray in a direction starts: in free space at its one start, else on the facet that
  /// faces it most, so that coarse convex surfaces do not shade themselves, and of facets in one
  /// plane on the one towards which it goes.
  /// Null if the point or all its facets face away.
  const glm::vec3* StartTowards(const glm::vec3& direction) const
  {
    if (this->IsInFreeSpace())
    {
      return &this->starts.front().origin;
    }
    constexpr float LittleMore = 1e-3f;
    const glm::vec3* best = nullptr;
    float most = -1.0f;
    if (glm::dot(direction, this->normal) > 0.0f)
    {
      for (const ReceiverStart& start : this->starts)
      {
        const float cosine = glm::dot(direction, start.normal);
        const float score = cosine + LittleMore * glm::dot(direction, start.inward);
        if (cosine > 0.0f && score > most)
        {
          most = score;
          best = &start.origin;
        }
      }
    }
    return best;
  }
};

} // namespace PhotonTransport

// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/openings/CoplanarSegments.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace PhotonTransport
{
namespace
{

/// How far a node may be off a plane, relative to the extent of what lies in it.
constexpr double Flatness = 1e-3;
/// Sine of the least angle at which two segments tell a plane.
constexpr double LeastTurn = 0.02;
/// Nodes with more segments than this, which walls hardly have, tell no plane.
constexpr std::size_t MostAtNode = 8;
/// How many segments are looked at for each of a part that is divided, lest a jagged rim takes
/// time with the square of its length.
constexpr std::size_t MostLooks = 64;

class Divider
{
public:
  explicit Divider(const OpenBorder& border)
    : Border(border)
    , AtNode(border.nodes.size())
    , Flats(border.segments.size())
    , InPart(border.segments.size(), 0)
  {
    for (std::uint32_t s = 0; s < border.segments.size(); ++s)
    {
      this->AtNode[border.segments[s].from].push_back(s);
      this->AtNode[border.segments[s].to].push_back(s);
    }
  }

  std::vector<CoplanarSegments> Divide()
  {
    for (std::uint32_t s = 0; s < this->Border.segments.size(); ++s)
    {
      if (this->InPart[s] == 0)
      {
        this->DividePart(this->PartWith(s));
      }
    }
    return std::move(this->Found);
  }

private:
  /// All segments that hang together with one.
  std::vector<std::uint32_t> PartWith(std::uint32_t first)
  {
    std::vector<std::uint32_t> part = this->Spread({ first }, [](std::uint32_t) { return true; });
    for (const std::uint32_t s : part)
    {
      this->InPart[s] = 1;
    }
    return part;
  }

  /// Adds the segments that hang together with some, as far as `belongs` says.
  template <typename Belongs>
  std::vector<std::uint32_t> Spread(std::vector<std::uint32_t> segments, const Belongs& belongs)
  {
    ++this->Mark;
    this->Marks.resize(this->Border.segments.size(), 0);
    for (const std::uint32_t s : segments)
    {
      this->Marks[s] = this->Mark;
    }
    for (std::size_t i = 0; i < segments.size(); ++i)
    {
      ++this->Looks;
      const BorderSegment& segment = this->Border.segments[segments[i]];
      for (const std::uint32_t node : { segment.from, segment.to })
      {
        for (const std::uint32_t other : this->AtNode[node])
        {
          if (this->Marks[other] != this->Mark && belongs(other))
          {
            this->Marks[other] = this->Mark;
            segments.push_back(other);
          }
        }
      }
    }
    return segments;
  }

  /// The plane through three nodes that lie far apart, if all nodes are in it.
  std::optional<Plane> PlaneOf(const std::vector<std::uint32_t>& part) const
  {
    const auto farthest = [&](const auto& distance)
    {
      glm::dvec3 best(0.0);
      double most = -1.0;
      for (const std::uint32_t s : part)
      {
        for (const std::uint32_t n : { this->Border.segments[s].from, this->Border.segments[s].to })
        {
          const double d = distance(this->Border.nodes[n]);
          best = d > most ? this->Border.nodes[n] : best;
          most = std::max(d, most);
        }
      }
      return best;
    };
    const glm::dvec3 any = this->Border.nodes[this->Border.segments[part.front()].from];
    const glm::dvec3 a = farthest([&](const glm::dvec3& p) { return glm::distance(p, any); });
    const glm::dvec3 b = farthest([&](const glm::dvec3& p) { return glm::distance(p, a); });
    const double extent = glm::distance(a, b);
    const glm::dvec3 along = (b - a) / extent;
    const auto beside = [&](const glm::dvec3& p) { return glm::length(glm::cross(p - a, along)); };
    const glm::dvec3 c = farthest(beside);
    if (!(beside(c) > Flatness * extent))
    {
      return std::nullopt;
    }
    const Plane plane{ a, glm::normalize(glm::cross(along, c - a)) };
    const glm::dvec3 worst = farthest([&](const glm::dvec3& p) { return plane.Distance(p); });
    return plane.Distance(worst) <= Flatness * extent ? std::optional(plane) : std::nullopt;
  }

  void DividePart(const std::vector<std::uint32_t>& part)
  {
    if (part.size() < 3)
    {
      return;
    }
    if (const std::optional<Plane> plane = this->PlaneOf(part))
    {
      this->Found.push_back({ *plane, part });
      return;
    }
    this->Looks = 0;
    for (const std::uint32_t s : part)
    {
      for (const std::uint32_t node :
        { this->Border.segments[s].from, this->Border.segments[s].to })
      {
        for (const std::uint32_t other : this->AtNode[node])
        {
          if (other > s && this->Looks <= MostLooks * part.size() &&
            this->AtNode[node].size() <= MostAtNode && !this->AreInOneFlat(s, other))
          {
            this->AddPlaneAt(node, s, other);
          }
        }
      }
    }
  }

  bool AreInOneFlat(std::uint32_t a, std::uint32_t b) const
  {
    const std::vector<std::uint32_t>&x = this->Flats[a], &y = this->Flats[b];
    return std::find_first_of(x.begin(), x.end(), y.begin(), y.end()) != x.end();
  }

  glm::dvec3 Along(std::uint32_t segment) const
  {
    const BorderSegment& s = this->Border.segments[segment];
    return this->Border.nodes[s.to] - this->Border.nodes[s.from];
  }

  /// Adds what lies in the plane of two segments that meet at a node.
  void AddPlaneAt(std::uint32_t node, std::uint32_t one, std::uint32_t other)
  {
    const glm::dvec3 a = this->Along(one), b = this->Along(other);
    const glm::dvec3 across = glm::cross(a, b);
    if (!(glm::length(across) > LeastTurn * glm::length(a) * glm::length(b)))
    {
      return;
    }
    const glm::dvec3& at = this->Border.nodes[node];
    const Plane plane{ at, glm::normalize(across) };
    const double least = std::min(glm::length(a), glm::length(b));
    const auto isIn = [&](std::uint32_t n)
    {
      const glm::dvec3& point = this->Border.nodes[n];
      return plane.Distance(point) <= Flatness * std::max(least, glm::distance(point, at));
    };
    const std::vector<std::uint32_t> flat = this->Spread({ one, other },
      [&](std::uint32_t s)
      { return isIn(this->Border.segments[s].from) && isIn(this->Border.segments[s].to); });
    const auto number = static_cast<std::uint32_t>(this->Found.size());
    const std::optional<Plane> whole =
      flat.size() < 3 ? std::nullopt : this->PlaneOf(flat); // more precise than the corner's
    if (whole)
    {
      this->Found.push_back({ *whole, flat });
      for (const std::uint32_t s : flat)
      {
        this->Flats[s].push_back(number);
      }
    }
  }

  const OpenBorder& Border;
  std::vector<std::vector<std::uint32_t>> AtNode; ///< Segments.
  std::vector<std::vector<std::uint32_t>> Flats;  ///< Of each segment, in Found.
  std::vector<std::uint8_t> InPart;
  std::vector<std::uint32_t> Marks;
  std::uint32_t Mark = 0;
  std::size_t Looks = 0;
  std::vector<CoplanarSegments> Found;
};

} // namespace

double Plane::Distance(const glm::dvec3& to) const
{
  return std::fabs(glm::dot(to - this->point, this->normal));
}

glm::dvec3 Plane::AnyDirection() const
{
  const glm::dvec3 size = glm::abs(this->normal);
  const int least = size.x <= size.y ? (size.x <= size.z ? 0 : 2) : (size.y <= size.z ? 1 : 2);
  glm::dvec3 axis(0.0);
  axis[least] = 1.0;
  return glm::normalize(glm::cross(axis, this->normal));
}

std::vector<CoplanarSegments> FindCoplanarSegments(const OpenBorder& border)
{
  return Divider(border).Divide();
}

} // namespace PhotonTransport

// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/refinement/Subdivision.h"

#include <glm/vec3.hpp>

#include <tuple>

namespace PhotonTransport
{
namespace
{

/// Barycentric coordinates with 20 binary places are exact in a float, and so are their halves'
/// sums.
constexpr int MostHalvings = 20;

struct Corner
{
  glm::vec3 barycentric;
  glm::vec3 position;
};

class Divider
{
public:
  Divider(std::uint32_t facet, const std::array<glm::vec3, 3>& corners, const HalvesEdge& halves,
    std::vector<FacetPart>& parts)
    : Facet(facet)
    , Corners(corners)
    , Halves(halves)
    , Parts(parts)
  {
  }

  /// @param halvings How often edges have been halved to get here.
  void Divide(const std::array<Corner, 3>& part, int halvings) const
  {
    // Edge i is opposite to corner i.
    std::array<bool, 3> halved{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      halved[i] = halvings < MostHalvings && this->AreHalved(part[(i + 1) % 3], part[(i + 2) % 3]);
    }
    const int number = halved[0] + halved[1] + halved[2];
    if (number == 0)
    {
      this->Keep(part, halvings);
      return;
    }
    // Turned so that edge 0 is halved where one is, and edge 0 is the one that is not where two
    // are.
    std::size_t first = 0;
    while (halved[first] != (number != 2))
    {
      ++first;
    }
    const Corner &a = part[first], &b = part[(first + 1) % 3], &c = part[(first + 2) % 3];
    for (const std::array<Corner, 3>& child : this->Children(number, a, b, c))
    {
      if (child[0].barycentric != child[1].barycentric)
      {
        this->Divide(child, halvings + 1);
      }
    }
  }

private:
  /// The order of the end points must not matter.
  bool AreHalved(const Corner& one, const Corner& other) const
  {
    const auto key = [](const glm::vec3& p) { return std::make_tuple(p.x, p.y, p.z); };
    const glm::vec3 &p = one.position, &q = other.position;
    return key(p) < key(q) ? this->Halves(p, q) : this->Halves(q, p);
  }

  Corner Middle(const Corner& one, const Corner& other) const
  {
    const glm::vec3 barycentric = 0.5f * (one.barycentric + other.barycentric);
    return { barycentric, PositionOf(barycentric, this->Corners) };
  }

  /// Two, three or four; what is left of the four has no extent.
  std::array<std::array<Corner, 3>, 4> Children(
    int number, const Corner& a, const Corner& b, const Corner& c) const
  {
    const std::array<Corner, 3> none{ a, a, a };
    if (number == 1) // the edge between b and c
    {
      const Corner m = this->Middle(b, c);
      return { { { a, b, m }, { a, m, c }, none, none } };
    }
    const Corner ab = this->Middle(a, b), ca = this->Middle(c, a);
    if (number == 2) // all but the edge between b and c
    {
      return { { { a, ab, ca }, { ab, b, c }, { ab, c, ca }, none } };
    }
    const Corner bc = this->Middle(b, c);
    return { { { a, ab, ca }, { ab, b, bc }, { ca, bc, c }, { ab, bc, ca } } };
  }

  void Keep(const std::array<Corner, 3>& part, int halvings) const
  {
    if (halvings > 0)
    {
      this->Parts.push_back(
        { this->Facet, { part[0].barycentric, part[1].barycentric, part[2].barycentric },
          { part[0].position, part[1].position, part[2].position } });
    }
  }

  std::uint32_t Facet;
  const std::array<glm::vec3, 3>& Corners;
  const HalvesEdge& Halves;
  std::vector<FacetPart>& Parts;
};

} // namespace

glm::vec3 PositionOf(const glm::vec3& barycentric, const std::array<glm::vec3, 3>& corners)
{
  return glm::vec3(double{ barycentric.x } * glm::dvec3(corners[0]) +
    double{ barycentric.y } * glm::dvec3(corners[1]) +
    double{ barycentric.z } * glm::dvec3(corners[2]));
}

void AppendParts(std::uint32_t facet, const std::array<glm::vec3, 3>& corners,
  const HalvesEdge& halves, std::vector<FacetPart>& parts)
{
  const std::array<Corner, 3> whole{ { { { 1, 0, 0 }, corners[0] }, { { 0, 1, 0 }, corners[1] },
    { { 0, 0, 1 }, corners[2] } } };
  Divider(facet, corners, halves, parts).Divide(whole, 0);
}

} // namespace PhotonTransport

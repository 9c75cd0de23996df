// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/openings/SeenOpening.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace PhotonTransport
{
namespace
{

/// Below this solid angle points are uniform by area: cosine and distance vary little over what is
/// so small, unless it is seen at a grazing angle and matters little.
constexpr double Small = 1e-3;

} // namespace

SeenOpening::SeenOpening(const Opening& opening, const glm::vec3& from)
  : Seen(opening)
  , From(from)
  , Height(
      glm::dot(this->From - glm::dvec3(opening.triangles.front()[0]), glm::dvec3(opening.normal)))
{
  if (!(this->Height > 0.0))
  {
    return;
  }
  double sum = 0.0;
  for (const Opening::Triangle& t : opening.triangles)
  {
    const auto towards = [&](const glm::vec3& corner)
    { return glm::normalize(glm::dvec3(corner) - this->From); };
    this->Triangles.emplace_back(towards(t[0]), towards(t[1]), towards(t[2]));
    sum += this->Triangles.back().SolidAngle();
    this->Angles.push_back(sum);
  }
}

OpeningSample SeenOpening::Sample(float u, float v) const
{
  const double angle = this->SolidAngle();
  if (!(angle > 0.0))
  {
    return {};
  }
  const glm::dvec3 normal(this->Seen.normal);
  if (angle < Small)
  {
    const glm::dvec3 to = glm::dvec3(this->Seen.PointAt(u, v)) - this->From;
    const double squared = glm::dot(to, to), distance = std::sqrt(squared);
    const double weight = double{ this->Seen.Area() } * this->Height / (squared * distance);
    return { glm::vec3(to / distance), static_cast<float>(distance), static_cast<float>(weight) };
  }
  const double wanted = double{ u } * angle;
  const auto found = std::upper_bound(this->Angles.begin(), this->Angles.end() - 1, wanted);
  const auto i = static_cast<std::size_t>(found - this->Angles.begin());
  const double before = i == 0 ? 0.0 : this->Angles[i - 1];
  const double within = (wanted - before) / (this->Angles[i] - before);
  const glm::dvec3 direction = this->Triangles[i].Sample(std::clamp(within, 0.0, 1.0), double{ v });
  const double outwards = -glm::dot(direction, normal);
  if (!(outwards > 0.0)) // by rounding, next to the plane
  {
    return {};
  }
  constexpr double Most = std::numeric_limits<float>::max();
  return { glm::vec3(direction), static_cast<float>(std::min(Most, this->Height / outwards)),
    static_cast<float>(angle) };
}

} // namespace PhotonTransport

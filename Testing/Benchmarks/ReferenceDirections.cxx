// SPDX-License-Identifier: BSD-3-Clause
#include "ReferenceDirections.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace
{

constexpr double Pi = 3.14159265358979323846;
/// Of the rays. Those that are not guided have weights up to 1 / (1 - share), which multiply along
/// a path: with half of the rays the variance had no end.
constexpr double GuidedShare = 0.25;

glm::dvec3 CosineDirection(const glm::dvec3& normal, const glm::dvec2& numbers)
{
  const glm::dvec3 aside = std::fabs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(aside, normal));
  const glm::dvec3 v = glm::cross(normal, u);
  const double r = std::sqrt(numbers.x);
  const double angle = 2.0 * Pi * numbers.y;
  return glm::normalize(r * std::cos(angle) * u + r * std::sin(angle) * v +
    std::sqrt(std::max(1e-12, 1.0 - numbers.x)) * normal);
}

} // namespace

ReferenceDirections::ReferenceDirections(
  const std::vector<Guide>& guides, const PhotonTransport::Placement& placement)
{
  for (const Guide& guide : guides)
  {
    const glm::dvec3 w = placement.scale * guide.halfWidth, h = placement.scale * guide.halfHeight;
    this->Guides.push_back({ placement.PointToScene(guide.centre), w, h, guide.normal,
      4.0 * glm::length(w) * glm::length(h) });
  }
}

bool ReferenceDirections::SceneGuide::Serves(const glm::dvec3& position) const
{
  return glm::dot(position - this->centre, this->normal) > 0.0;
}

/// Of the directions to places that are spread evenly over the guide, 1/sr.
double ReferenceDirections::SceneGuide::Density(
  const glm::dvec3& position, const glm::dvec3& direction) const
{
  const double fall = -glm::dot(direction, this->normal);
  const double distance = glm::dot(position - this->centre, this->normal) / fall;
  const glm::dvec3 across = position + distance * direction - this->centre;
  const glm::dvec3 &w = this->halfWidth, &h = this->halfHeight;
  const bool meets = fall > 0.0 && std::fabs(glm::dot(across, w)) <= glm::dot(w, w) &&
    std::fabs(glm::dot(across, h)) <= glm::dot(h, h);
  return meets ? distance * distance / (this->area * fall) : 0.0;
}

glm::dvec3 ReferenceDirections::Draw(
  const LitPlace& from, const glm::dvec2& numbers, double choice) const
{
  const auto serves = [&](const SceneGuide& guide) { return guide.Serves(from.position); };
  const auto count = std::count_if(this->Guides.begin(), this->Guides.end(), serves);
  if (count == 0 || choice >= GuidedShare)
  {
    return CosineDirection(from.normal, numbers);
  }
  auto left = std::min(
    static_cast<std::ptrdiff_t>(choice / GuidedShare * static_cast<double>(count)), count - 1);
  auto guide = std::find_if(this->Guides.begin(), this->Guides.end(), serves);
  while (left-- > 0)
  {
    guide = std::find_if(guide + 1, this->Guides.end(), serves);
  }
  return glm::normalize(guide->centre + (2.0 * numbers.x - 1.0) * guide->halfWidth +
    (2.0 * numbers.y - 1.0) * guide->halfHeight - from.position);
}

double ReferenceDirections::Density(const LitPlace& from, const glm::dvec3& direction) const
{
  const double cosine = std::max(0.0, glm::dot(direction, from.normal)) / Pi;
  double guided = 0.0;
  unsigned count = 0;
  for (const SceneGuide& guide : this->Guides)
  {
    if (guide.Serves(from.position))
    {
      ++count;
      guided += guide.Density(from.position, direction);
    }
  }
  return count == 0 ? cosine : (1.0 - GuidedShare) * cosine + GuidedShare * guided / count;
}

// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/registration/FacetCells.h"

#include "PhotonTransport/scene/Scene.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace PhotonTransport
{

FacetCells::FacetCells(const Scene& scene, const std::vector<float>& lengths, std::size_t most)
  : Divisions(lengths.size())
{
  constexpr float Longer = 1.25f;
  for (float factor = 1.0f;; factor *= Longer)
  {
    this->All = 0;
    for (std::uint32_t f = 0; f < lengths.size(); ++f)
    {
      Division& division = this->Divisions[f];
      division = Divide(scene, f, factor * lengths[f]);
      division.first = static_cast<std::uint32_t>(this->All);
      this->All += std::size_t{ division.strips } * division.columns;
    }
    if (this->All <= std::max(most, lengths.size()))
    {
      break;
    }
  }
}

glm::vec3 FacetCells::PointIn(std::uint32_t facet, std::uint32_t cell, float u, float v) const
{
  const Division& division = this->Divisions[facet];
  const std::uint32_t inFacet = cell - division.first;
  const auto strip = static_cast<float>(inFacet / division.columns);
  const auto column = static_cast<float>(inFacet % division.columns);
  // The width of the facet falls linearly with the height, so the area above a height as its
  // square.
  const float below = 1.0f - strip / static_cast<float>(division.strips);
  const float above = 1.0f - (strip + 1.0f) / static_cast<float>(division.strips);
  const float width = std::sqrt(below * below + u * (above * above - below * below));
  const float along = (column + v) / static_cast<float>(division.columns);
  glm::vec3 barycentric;
  barycentric[division.apex] = 1.0f - width;
  barycentric[(division.apex + 1) % 3] = width * along;
  barycentric[(division.apex + 2) % 3] = width * (1.0f - along);
  return barycentric;
}

FacetCells::Division FacetCells::Divide(const Scene& scene, std::uint32_t facet, float length)
{
  const glm::uvec3& ids = scene.Facets()[facet].vertices;
  const auto corner = [&](int i) { return scene.Vertices()[ids[i]].position; };
  Division division;
  float base = 0.0f;
  for (int i = 0; i < 3; ++i)
  {
    const float edge = glm::distance(corner((i + 1) % 3), corner((i + 2) % 3));
    if (edge > base)
    {
      base = edge;
      division.apex = static_cast<std::uint8_t>(i);
    }
  }
  const float height = 2.0f * glm::length(scene.AreaVectors()[facet]) / base;
  const auto parts = [&](float extent)
  {
    constexpr float Most = 4096.0f;
    return static_cast<std::uint16_t>(std::clamp(std::ceil(extent / length), 1.0f, Most));
  };
  division.strips = parts(height);
  division.columns = parts(base);
  division.length = std::max(
    height / static_cast<float>(division.strips), base / static_cast<float>(division.columns));
  return division;
}

} // namespace PhotonTransport

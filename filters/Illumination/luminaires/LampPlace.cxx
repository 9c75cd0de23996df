// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/luminaires/LampPlace.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <limits>

namespace Illumination
{
namespace
{

bool IsIn(const glm::dvec3& place, const Box& box)
{
  return glm::all(glm::greaterThanEqual(place, box.least)) &&
    glm::all(glm::lessThanEqual(place, box.most));
}

} // namespace

Box BoxOf(const PhotonTransport::Surface& surface)
{
  constexpr double Largest = std::numeric_limits<double>::max();
  Box box{ glm::dvec3(Largest), glm::dvec3(-Largest) };
  for (const glm::uvec3& facet : surface.facets)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      box.least = glm::min(box.least, surface.points[facet[corner]]);
      box.most = glm::max(box.most, surface.points[facet[corner]]);
    }
  }
  return box;
}

std::optional<glm::dvec3> PlaceOf(const PhotonTransport::Lamp& lamp)
{
  return std::visit([](const auto& l) { return l.Place(); }, lamp);
}

std::string HintOnUnits(const glm::dvec3& place, const Box& box)
{
  struct Unit
  {
    double times;
    const char* words;
  };
  constexpr Unit Units[] = { { 1e-3, "divided by 1000, as from millimetres to metres" },
    { 1e-2, "divided by 100, as from centimetres to metres" },
    { 1e-1, "divided by 10, as from millimetres to centimetres" },
    { 0.0254, "times 0.0254, as from inches to metres" },
    { 0.3048, "times 0.3048, as from feet to metres" },
    { 1e3, "times 1000, as from metres to millimetres" },
    { 1e2, "times 100, as from metres to centimetres" } };
  // How far outside the surface a lamp is whose unit is wrong: about as many times its size as the
  // units differ. A lamp that is not so far may well be meant to be there.
  const double size = glm::distance(box.least, box.most);
  const double distance = glm::distance(place, glm::clamp(place, box.least, box.most));
  if (distance > size)
  {
    for (const Unit& unit : Units)
    {
      if (IsIn(unit.times * place, box) && distance * unit.times > 0.1 * size)
      {
        return std::string(" The lamp's position ") + unit.words + ", is within the surface's box.";
      }
    }
  }
  return "";
}

} // namespace Illumination
